module t(input [7:0] a, input signed [2:0] n, output [7:0] y);
  assign y = n < 0 ? a << -n : a >> n;
endmodule
