module t(input clk, d, output y);
  logic q = 1;
  always @(posedge clk) q <= q | d;
  assign y = q;
endmodule
