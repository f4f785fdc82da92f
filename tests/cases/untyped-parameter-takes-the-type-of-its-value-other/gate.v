module t(input signed [7:0] a, output signed [7:0] y);
  wire signed [7:0] sum = a + 8'd1;
  assign y = sum >>> 1;
endmodule
