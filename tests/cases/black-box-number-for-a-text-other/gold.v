module t(input a, b, output y);
  // A text is no number.
  PLL #(.P("A")) p(.A(a), .Y(y));
endmodule
