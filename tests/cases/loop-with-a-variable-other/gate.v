module t(input [6:0] a, output reg [2:0] y);
  always @* y = a[0] + a[1] + a[2] + a[3] + a[4] + a[5];
endmodule
