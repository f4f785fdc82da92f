module t(input a, b, output y);
  // The same real number.
  PLL #(.P(25.0e-1)) p(.A(a), .Y(y));
endmodule
