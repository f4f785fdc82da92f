module t(input a, output y);
  // A real number is not rounded.
  PLL #(.PERIOD(10.2)) p(.A(a), .Y(y));
endmodule
