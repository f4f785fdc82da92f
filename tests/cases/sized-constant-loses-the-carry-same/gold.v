// All operands and the target have eight bits.
module t(input [7:0] a, b, output [7:0] y);
  assign y = (a + b + 1'b0) >> 1;
endmodule
