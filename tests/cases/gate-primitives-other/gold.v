// Primitives of more than two inputs.
module t(input a, b, c, output [3:0] y);
  nand g0(y[0], a, b, c);
  nor g1(y[1], a, b, c);
  xnor g2(y[2], a, b, c);
  not g3(y[3], a);
endmodule
