module t(input [2:0] n, output signed [3:0] y);
  assign y = 4'h1;
endmodule
