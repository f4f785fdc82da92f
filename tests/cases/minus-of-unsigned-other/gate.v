module t(input [3:0] a, output y);
  assign y = 1'b1;
endmodule
