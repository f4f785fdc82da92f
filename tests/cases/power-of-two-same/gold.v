// 2 ** n in the width of the target.
module t(input [2:0] n, output [7:0] y);
  assign y = 2 ** n;
endmodule
