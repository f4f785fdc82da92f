module t(input [2:0] n, output [7:0] y);
  assign y = n * 2;
endmodule
