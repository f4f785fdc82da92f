module t(input [3:0] a, output [3:0] y);
  part p(a, y);
endmodule
