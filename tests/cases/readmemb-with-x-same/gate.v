module t(input [1:0] a, output [3:0] q);
  assign q = (1 << a) | (a == 2);
endmodule
