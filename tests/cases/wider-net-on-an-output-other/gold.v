// A port is connected as by an assignment: the upper bits of a wider net are 0.
module below(input [1:0] i, output [1:0] o);
  assign o = ~i;
endmodule
module t(input [1:0] a, output [3:0] y);
  below u(a, y);
endmodule
