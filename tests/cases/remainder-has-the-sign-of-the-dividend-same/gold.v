// -7 % 4 is -3.
module t(input signed [3:0] a, output signed [3:0] y);
  assign y = a % 4;
endmodule
