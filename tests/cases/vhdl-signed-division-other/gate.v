module t(input signed [3:0] a, b, output signed [3:0] q);
  wire [3:0] n = a, m = b;
  assign q = b == 0 ? 4'd0 : n / m;
endmodule
