// A defparam overrides the parameter of an instance.
module below #(parameter P = 1, Q = P + 1)(input [3:0] a, output [3:0] y);
  assign y = a + P + Q;
endmodule
module t(input [3:0] a, output [3:0] y);
  below u(a, y);
  defparam u.P = 3;
endmodule
