// A parameter with a range and without signed is unsigned.
module below #(parameter [3:0] P = -1)(input signed [7:0] a, output signed [7:0] y);
  assign y = a + P;
endmodule
module t(input signed [7:0] a, output signed [7:0] y);
  below  u(a, y);
endmodule
