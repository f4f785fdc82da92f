// One unsigned operand makes the division unsigned.
module t(input signed [3:0] a, input [3:0] b, output [3:0] y);
  assign y = b == 0 ? 4'd0 : a / b;
endmodule
