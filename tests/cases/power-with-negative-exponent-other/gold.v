// 2 to a negative power is 0 in whole numbers.
module t(input signed [2:0] n, output [7:0] y);
  assign y = 8'sd2 ** n;
endmodule
