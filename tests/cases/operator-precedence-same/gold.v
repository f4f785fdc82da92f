// Comparisons bind more than &, shifts less than +, ?: to the right.
module t(input [3:0] a, b, c, output [3:0] y);
  assign y = a & b == c ? a + b << 1 : a < b < c ? ~a + 1 : -b;
endmodule
