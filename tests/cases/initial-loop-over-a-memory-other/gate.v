module t(input [2:0] a, output [5:0] q);
  assign q = a + a;
endmodule
