module t(input [3:0] a, output y);
  // All of a net is compared, whatever kind it is.
  enum logic [3:0] { IDLE, RUN } n;
  assign n = {~a[3], a[2:0]};
  PLL p(.A(n), .Y(y));
endmodule
