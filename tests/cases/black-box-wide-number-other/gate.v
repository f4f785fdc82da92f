module t(input a, b, output y);
  // A number may be wide.
  PLL #(.P(300'd1 << 281)) p(.A(a), .Y(y));
endmodule
