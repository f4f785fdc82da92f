module t(input a, b, output y);
  // A real number may have an exponent and no point.
  PLL #(.P(2e-3)) p(.A(a), .Y(y));
endmodule
