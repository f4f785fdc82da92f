// A concatenation of one signed operand on a port.
module flip(input [3:0] i, output [3:0] o);
  assign o = ~i;
endmodule
module t(input signed [3:0] a, output signed [3:0] y);
  flip f(.i({a}), .o({y}));
endmodule
