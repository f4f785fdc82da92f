module t(input [3:0] a, output y);
  // All of a net is compared, whatever kind it is.
  integer n;
  always @* n = {~a[3], a[2:0]};
  PLL p(.A(n), .Y(y));
endmodule
