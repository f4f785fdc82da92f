// Logic reads the clock: it is compared on both sides of the edge.
module t(input clk, input rst, input d, output reg q, output y);
  always @(posedge clk) q <= d | clk;
  assign y = d;
endmodule
