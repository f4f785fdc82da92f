// One unsigned operand makes the whole expression unsigned, the shift too.
module t(input signed [7:0] s, input [7:0] u, output [7:0] y);
  assign y = (s >>> 1) + u;
endmodule
