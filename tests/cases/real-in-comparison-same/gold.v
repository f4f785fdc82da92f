// A comparison with a real constant is made in real numbers.
module t(input [3:0] a, output y);
  assign y = a >= 2.0;
endmodule
