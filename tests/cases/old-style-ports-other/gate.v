module t(input [1:0] a, input b, output y);
  assign y = a[0] ^ (a[1] | b);
endmodule
