module t(input a, b, output y);
  // A text is no number.
  PLL #(.P(65)) p(.A(a), .Y(y));
endmodule
