module t(input signed [3:0] a, output signed [3:0] y);
  assign y = a >>> 1;
endmodule
