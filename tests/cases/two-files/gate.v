module adder(input [1:0] x, y, output [2:0] z);
  assign z = x + y;
endmodule
