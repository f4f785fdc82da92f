module t(input [1:0] a, output y);
  assign y = ~a[1];
endmodule
