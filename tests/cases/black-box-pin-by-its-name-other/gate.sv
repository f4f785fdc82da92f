module t(input a, b, output y);
  wire pin = b;
  PLL p(.pin, .Y(y));
endmodule
