module t(input [3:0] a, output [3:0] y);
  assign y = {4{a[3]}};
endmodule
