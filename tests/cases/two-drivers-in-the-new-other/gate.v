module t(input a, b, output y);
  assign y = a;
  assign y = b;
endmodule
