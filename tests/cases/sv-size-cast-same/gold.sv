// A cast to a size cuts the sum.
module t(input [3:0] a, b, output [7:0] y);
  assign y = 4'(a + b);
endmodule
