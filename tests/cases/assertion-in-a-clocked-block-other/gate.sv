module t(input clk, a, b, output reg y);
  always @(posedge clk) y <= b;
  always @(posedge clk) assert (a | ~a);
endmodule
