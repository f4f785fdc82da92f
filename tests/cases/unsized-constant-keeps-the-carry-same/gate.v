module t(input [7:0] a, b, output [7:0] y);
  wire [8:0] sum = a + b;
  assign y = sum[8:1];
endmodule
