// The first instance of [0:2] gets the most significant bits.
module cell_of(input [1:0] i, output o);
  assign o = i[1] | ~i[0];
endmodule
module t(input [5:0] a, output [2:0] y);
  cell_of u[0:2](.i(a), .o(y));
endmodule
