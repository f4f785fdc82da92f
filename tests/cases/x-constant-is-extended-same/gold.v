// 8'bx is x in all bits, 8'bx0 in all but one.
module t(input a, output [7:0] y);
  assign y = a ? 8'bx0 : 8'bx;
endmodule
