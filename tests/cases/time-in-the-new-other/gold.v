// The new RTL reads $time.
module t(input clk, d, output reg y);
  always @(posedge clk) y <= d;
endmodule
