module t(input s, a, b, output y);
  assign y = s ? b : a;
endmodule
