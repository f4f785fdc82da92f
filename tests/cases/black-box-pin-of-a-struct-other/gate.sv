module t(input [3:0] a, output y);
  // All of a net is compared, whatever kind it is.
  struct packed { logic [1:0] high, low; } n;
  assign n = {~a[3], a[2:0]};
  PLL p(.A(n), .Y(y));
endmodule
