// The order of two blocks at one edge is not defined.
module t(input clk, d, output reg q);
  reg p;
  always @(posedge clk) p = d;
  always @(posedge clk) q = p;
endmodule
