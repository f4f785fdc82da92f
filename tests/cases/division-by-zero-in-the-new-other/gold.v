// The new RTL is x where b is 0.
module t(input [3:0] a, b, output [3:0] y);
  assign y = b == 0 ? 4'd15 : a / b;
endmodule
