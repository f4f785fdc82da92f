module t(input [3:0] a, b, output [3:0] y);
  assign y = {~a[0], a[0] & b[0], |{a, b}, ~|(a & b)};
endmodule
