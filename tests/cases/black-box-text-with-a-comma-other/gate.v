module t(input a, output y);
  PLL #(.MODE("A,C("), .MULTIPLY(16)) p(.A(a), .Y(y));
endmodule
