module t(input a, b, output y);
  // An x is a digit of its own.
  PLL #(.P(4'bxx01)) p(.A(a), .Y(y));
endmodule
