module t(input a, output y);
  t u(a, y);
endmodule
