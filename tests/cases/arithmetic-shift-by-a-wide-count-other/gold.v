// An arithmetic shift by a wide count leaves the sign alone.
module t(input signed [7:0] a, input [33:0] n, output signed [7:0] y);
  assign y = a >>> n;
endmodule
