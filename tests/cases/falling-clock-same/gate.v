module t(input clk, rst, d, output reg q);
  always @(negedge clk) q <= ~rst & (d ^ q);
endmodule
