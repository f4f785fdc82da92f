// A procedural force.
module t(input clk, d, e, output reg q);
  always @(posedge clk) q <= d;
  always @(e) if (e) force q = 1; else release q;
endmodule
