module t(input [3:0] a, output y);
  assign y = a == 0;
endmodule
