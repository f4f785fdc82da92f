module t(input a, b, output y);
  wire pin = a;
  PLL p(.pin, .Y(y));
endmodule
