module t(input signed [7:0] a, output signed [7:0] y);
  assign y = a + 8'd15;
endmodule
