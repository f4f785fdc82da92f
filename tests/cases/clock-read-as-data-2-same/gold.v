// A register reads its clock: its value depends on the order of events, so nothing is decided.
module t(input clk, input rst, input d, output reg q, output y);
  always @(posedge clk) q <= d | clk;
  assign y = d;
endmodule
