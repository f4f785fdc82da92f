module t(input [3:0] a, b, output c, output [3:0] y);
  wire [4:0] s = {1'b0, a} + {1'b0, b};
  assign c = s[4], y = s[3:0];
endmodule
