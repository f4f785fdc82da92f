// A vector on a port of an array of instances is cut; a bit goes to all.
module cell_of(input [1:0] i, input e, output o);
  assign o = (i[1] | ~i[0]) & e;
endmodule
module t(input [5:0] a, input e, output [2:0] y);
  cell_of u[2:0](.i(a), .e(e), .o(y));
endmodule
