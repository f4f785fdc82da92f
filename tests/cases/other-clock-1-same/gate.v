module t(input a, b, d, output reg q);
  always @(posedge a) q <= d;
endmodule
