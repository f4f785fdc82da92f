// A reduction is one bit, unsigned, and extended with zeros.
module t(input signed [4:0] a, input [2:0] b, output [3:0] y);
  assign y = &a + ^b - (~|a);
endmodule
