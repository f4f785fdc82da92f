module t(input clk, input [1:0] a, input [3:0] d, output [2:0] y);
  reg [3:0] m [0:3];
  always @(posedge clk) m[a] <= d;
  wire [3:0] w = m[a];
  assign y = w[3:1];
endmodule
