// A parameter that is declared signed stays so.
module below #(parameter signed [3:0] P = 0)(input signed [7:0] a, output signed [7:0] y);
  assign y = a + P;
endmodule
module t(input signed [7:0] a, output signed [7:0] y);
  below #(.P(4'd15)) u(a, y);
endmodule
