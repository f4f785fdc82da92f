module t(input clk, rst, input [1:0] d, output reg [1:0] q);
  always @(posedge clk) q <= rst ? 0 : d + 1;
endmodule
