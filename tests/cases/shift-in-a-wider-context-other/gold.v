// The operand of a shift has the width of the target.
module t(input [7:0] a, output [15:0] y);
  assign y = a << 4;
endmodule
