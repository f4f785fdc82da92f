// An int begins at 0.
module t(input clk, d, output y);
  int q;
  always @(posedge clk) q <= q | d;
  assign y = q[0];
endmodule
