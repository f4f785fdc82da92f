module t(input signed [3:0] a, output signed [3:0] y);
  wire signed [3:0] up = a + {3'd0, a[3]};
  assign y = up >>> 1;
endmodule
