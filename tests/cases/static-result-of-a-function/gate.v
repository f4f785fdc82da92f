module t(input clk, a, b, output reg y);
  always @(posedge clk) y <= a & b;
endmodule
