module t(input [3:0] a, output y);
  assign y = a[3] & ~a[1];
endmodule
