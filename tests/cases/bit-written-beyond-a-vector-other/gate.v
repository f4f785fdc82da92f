module t(input [3:0] n, input d, output reg [9:0] y);
  always @* y = d << (n % 10);
endmodule
