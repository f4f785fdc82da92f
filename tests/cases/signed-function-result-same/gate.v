module t(input signed [3:0] a, output signed [7:0] y);
  wire signed [3:0] h = a >>> 1;
  assign y = h;
endmodule
