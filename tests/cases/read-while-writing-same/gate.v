module t(input clk, we, input [1:0] a, input [3:0] d, output reg [3:0] q);
  reg [3:0] m [0:3];
  wire [3:0] old = m[a];
  always @(posedge clk) q <= old;
  always @(posedge clk) if (we) m[a] <= d;
endmodule
