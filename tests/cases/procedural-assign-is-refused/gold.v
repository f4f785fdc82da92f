// A procedural assign and deassign.
module t(input clk, d, e, output reg q);
  always @(posedge clk) q <= d;
  always @(e) if (e) assign q = 1; else deassign q;
endmodule
