module t(input [2:0] n, output [7:0] y);
  assign y = 8'd1 << n;
endmodule
