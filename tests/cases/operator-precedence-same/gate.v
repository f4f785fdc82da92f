module t(input [3:0] a, b, c, output [3:0] y);
  wire [3:0] s = a + b;
  assign y = (a[0] & (b == c)) ? {s[2:0], 1'b0} : ({3'd0, a < b} < c) ? 4'd0 - a : 4'd0 - b;
endmodule
