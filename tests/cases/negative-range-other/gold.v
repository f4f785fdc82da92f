// A vector [3:-2].
module t(input [3:-2] a, output [5:0] y);
  assign y = {a[-2], a[-1 +: 2], a[3:1]};
endmodule
