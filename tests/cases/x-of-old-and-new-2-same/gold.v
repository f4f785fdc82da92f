// Any value will do for an x of the old RTL; an x of the new one must be right as 0 and as 1.
module t(input clk, input rst, input s, output reg [1:0] q);
  always @(posedge clk) if (s) q <= 1;
  else q <= 2'bx;
endmodule
