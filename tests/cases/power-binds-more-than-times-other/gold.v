// Powers are taken from the left, and before products.
module t(input [3:0] a, output [7:0] y);
  assign y = 3 * a ** 2;
endmodule
