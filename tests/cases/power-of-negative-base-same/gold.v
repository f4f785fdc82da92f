// A power of -1 is 1 or -1.
module t(input [2:0] n, output signed [3:0] y);
  assign y = (-4'sd1) ** n;
endmodule
