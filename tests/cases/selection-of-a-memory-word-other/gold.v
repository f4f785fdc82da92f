// Bits and parts of a word of a memory.
module t(input clk, input [1:0] a, input [3:0] d, output [2:0] y);
  reg [3:0] m [0:3];
  always @(posedge clk) m[a] <= d;
  assign y = {m[a][3], m[a][2:1]};
endmodule
