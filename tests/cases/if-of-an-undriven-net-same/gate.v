module t(input clk, e, input [3:0] a, output reg q, output [3:0] y);
  reg u, p;
  wire v = u & e;
  always @(posedge clk) p <= v;
  always @(posedge clk) q <= p;
  assign y = a - 4'hf;
endmodule
