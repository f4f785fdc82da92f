module t(input [11:0] a, input [1:0] i, output [3:0] y);
  assign y = i == 3 ? 4'd0 : a[4*i +: 4];
endmodule
