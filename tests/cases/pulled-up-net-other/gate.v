module t(input a, s, output y);
  assign y = s ? a : 1'b0;
endmodule
