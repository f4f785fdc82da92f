module t(input signed [7:0] a, output signed [7:0] y);
  wire [7:0] sum = a + 8'd1;
  assign y = {1'b0, sum[7:1]};
endmodule
