module half(input a, b, output s, c);
  assign {c, s} = a + b;
endmodule
module adder(input [1:0] x, y, output [2:0] z);
  wire c, d, e;
  half h0(.a(x[0]), .b(y[0]), .s(z[0]), .c(c));
  half h1(.a(x[1]), .b(y[1]), .s(d), .c(e));
  assign z[1] = c ^ d, z[2] = e | c & d;
endmodule
