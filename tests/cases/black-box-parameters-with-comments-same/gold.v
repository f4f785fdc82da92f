module t(input a, output y);
  (* keep *) PLL #(.PERIOD(10), .MODE("A,B("), .MULTIPLY(16)) p(.A(a), .Y(y));
endmodule
