module t(input a, b, output y);
  // An x is a digit of its own.
  PLL #(.P(4'b0001)) p(.A(a), .Y(y));
endmodule
