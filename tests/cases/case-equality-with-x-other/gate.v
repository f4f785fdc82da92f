module t(input a, b, c, output y);
  assign y = b;
endmodule
