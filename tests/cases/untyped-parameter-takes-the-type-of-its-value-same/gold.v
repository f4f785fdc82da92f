// P is signed or not as the value that it is given.
module below #(parameter P = 0)(input signed [7:0] a, output signed [7:0] y);
  assign y = (a + P) >>> 1;
endmodule
module t(input signed [7:0] a, output signed [7:0] y);
  below #(.P(8'd1)) u(a, y);
endmodule
