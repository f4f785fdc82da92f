module t(input [7:0] a, b, output [7:0] y);
  wire [7:0] sum = a + b;
  assign y = {1'b0, sum[7:1]};
endmodule
