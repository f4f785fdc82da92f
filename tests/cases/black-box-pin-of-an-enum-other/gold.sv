module t(input [3:0] a, output y);
  // All of a net is compared, whatever kind it is.
  enum logic [1:0] { IDLE, RUN, HALT, WAIT } n;
  assign n = a[1] ? (a[0] ? WAIT : HALT) : (a[0] ? RUN : IDLE);
  PLL p(.A(n), .Y(y));
endmodule
