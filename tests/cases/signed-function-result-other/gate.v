module t(input signed [3:0] a, output signed [7:0] y);
  assign y = {4'd0, a[3], a[3:1]};
endmodule
