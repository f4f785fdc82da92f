module t(input a, b, output y);
  // The same real number.
  PLL #(.P(2.50)) p(.A(a), .Y(y));
endmodule
