module t(input [3:0] n, input d, output reg [9:0] y);
  wire [15:0] w = d << n;
  always @* y = w[9:0];
endmodule
