module t(input clk, input [1:0] a, output reg y);
  always @(posedge clk) y <= &a;
endmodule
