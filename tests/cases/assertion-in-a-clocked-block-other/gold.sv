// An assertion in a clocked block.
module t(input clk, a, b, output reg y);
  always @(posedge clk) y <= a;
  always @(posedge clk) assert (a | ~a);
endmodule
