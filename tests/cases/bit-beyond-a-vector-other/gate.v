module t(input [9:0] a, input [3:0] n, output y);
  assign y = a[n];
endmodule
