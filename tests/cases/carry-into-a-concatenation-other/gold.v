// The target {c, y} has a bit more than the sum's operands.
module t(input [3:0] a, b, output c, output [3:0] y);
  assign {c, y} = a + b;
endmodule
