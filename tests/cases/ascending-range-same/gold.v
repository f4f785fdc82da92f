// A vector [0:7] has its most significant bit at 0.
module t(input [0:7] a, input [1:0] i, output [3:0] y);
  assign y = {a[0], a[i +: 2], a[7 - i]};
endmodule
