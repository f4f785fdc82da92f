// The operand of a shift in a concatenation has its own width.
module t(input [7:0] a, output [15:0] y);
  assign y = {8'd0, a << 4};
endmodule
