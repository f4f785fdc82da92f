// The message names the register and its clock.
module t(input clk, en, d, output reg q);
  wire g = clk & en;
  always @(posedge g) q <= d;
endmodule
