module t(input clk, input [7:0] a, output reg [7:0] q);
  wire [7:0] z = a;
  always @(posedge clk) q <= z;
endmodule
