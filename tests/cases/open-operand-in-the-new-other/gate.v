module t(input [3:0] a, output [3:0] y);
  below u(.i(a), .o(y));
endmodule
module below(input [3:0] i, j, output [3:0] o);
  assign o = i | (j & ~i);
endmodule
