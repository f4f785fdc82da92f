// A register of each edge of one clock.
module t(input clk, d, output reg q);
  reg p;
  always @(posedge clk) p <= d;
  always @(negedge clk) q <= p;
endmodule
