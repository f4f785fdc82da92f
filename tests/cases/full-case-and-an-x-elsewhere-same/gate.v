module t(input [1:0] a, input s, output y, output [1:0] z);
  assign y = a[s], z = s ? 1 : a;
endmodule
