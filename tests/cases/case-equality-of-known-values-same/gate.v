module t(input [3:0] a, b, output y);
  assign y = ~|(a ^ b);
endmodule
