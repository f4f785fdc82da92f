// A register begins as an initial block says.
module t(input clk, d, output reg [1:0] q);
  initial q = 2'd2;
  always @(posedge clk) if (d) q <= q + 1;
endmodule
