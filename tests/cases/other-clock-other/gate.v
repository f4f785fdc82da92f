module t(input a, b, d, output reg q);
  always @(posedge b) q <= d;
endmodule
