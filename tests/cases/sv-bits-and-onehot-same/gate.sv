module t(input [4:0] a, output [3:0] y);
  wire [3:0] n = a[0] + a[1] + a[2] + a[3] + a[4];
  assign y = n + 4'd5 + (n == 1);
endmodule
