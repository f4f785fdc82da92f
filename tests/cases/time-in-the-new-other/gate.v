module t(input clk, d, output reg y);
  always @(posedge clk) y <= d ^ ($time > 100);
endmodule
