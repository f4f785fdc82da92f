module t(input a, output y);
  // A real number is not rounded.
  PLL #(.PERIOD(10.0)) p(.A(a), .Y(y));
endmodule
