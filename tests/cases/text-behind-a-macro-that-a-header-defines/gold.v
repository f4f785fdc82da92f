`include "more.vh"
module t(input clk, input d, output reg q);
`ifdef WAITS
  always @(posedge clk) begin if (d) #1; q <= d; end
`else
  always @(posedge clk) q <= d;
`endif
endmodule
