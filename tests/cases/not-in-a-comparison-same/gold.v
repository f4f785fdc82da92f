// The complement has the width of the other operand.
module t(input [3:0] a, input [7:0] b, output y);
  assign y = ~a == b;
endmodule
