module t(input [3:0] a, output [2:0] y);
  assign y = a[3] ? 3 : a[2] ? 2 : a[1] ? 1 : a[0] ? 0 : 4;
endmodule
