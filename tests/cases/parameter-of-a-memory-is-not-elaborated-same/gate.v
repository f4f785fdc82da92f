module t #(parameter DEPTH = 16384)(input clk, we, input [5:0] a, input [31:0] d, output reg [31:0] q);
  reg [31:0] m [0:DEPTH-1];
  wire [31:0] r = m[a];
  always @(posedge clk) q <= r;
  always @(posedge clk) if (we) m[a] <= d;
endmodule
