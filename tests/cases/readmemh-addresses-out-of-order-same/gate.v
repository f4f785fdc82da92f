module t(input [1:0] a, output [3:0] q);
  assign q = a == 0 ? 4 : a == 1 ? 8 : a == 2 ? 1 : 2;
endmodule
