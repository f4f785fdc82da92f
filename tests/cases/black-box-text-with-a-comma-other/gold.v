module t(input a, output y);
  PLL #(.MODE("A,B("), .MULTIPLY(16)) p(.A(a), .Y(y));
endmodule
