module t(input [3:0] a, input s, output y, z);
  assign y = a == 0, z = a[s];
endmodule
