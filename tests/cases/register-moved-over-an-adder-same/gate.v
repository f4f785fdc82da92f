module t(input clk, input rst, input [7:0] a, b, output reg [8:0] q);
  always @(posedge clk) q <= a + b;
endmodule
