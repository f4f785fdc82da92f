module t(input [3:0] a, output y);
  assign y = a == 1 | (a >= 5 & a <= 7) | (a[3] & a[2] & ~a[0]);
endmodule
