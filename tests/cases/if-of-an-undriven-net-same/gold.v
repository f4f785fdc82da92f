// An if that reads an x takes one way in a simulator, for good.
module t(input clk, e, input [3:0] a, output reg q, output [3:0] y);
  reg u, p;
  wire v = u & e;
  always @(posedge clk) if (v) p <= 1; else p <= 0;
  always @(posedge clk) q <= p;
  assign y = a + 1;
endmodule
