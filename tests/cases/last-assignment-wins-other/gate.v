module t(input clk, rst, input [3:0] d, output reg [3:0] q);
  always @(posedge clk) q <= {4{~rst}} & d;
endmodule
