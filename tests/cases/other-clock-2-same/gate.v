module t(input c, b, d, output reg q);
  wire e = d;
  always @(posedge c) q <= e & d;
endmodule
