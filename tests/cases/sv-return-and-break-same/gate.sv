module t(input [3:0] a, output [2:0] y);
  assign y = a[0] ? 0 : a[1] ? 1 : a[2] ? 2 : a[3] ? 3 : 4;
endmodule
