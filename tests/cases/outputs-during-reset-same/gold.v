// The outputs during the reset are compared only with --reset-clocks 0.
module t(input clk, input rst, output reg [3:0] q);
  initial q = 3;
  always @(posedge clk) if (rst) q <= 0;
  else q <= q + 1;
endmodule
