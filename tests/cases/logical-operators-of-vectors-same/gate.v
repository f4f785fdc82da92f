module t(input [3:0] a, b, output [3:0] y);
  assign y = {~|a, (|a) & (|b), (|a) | (|b), ~|(a & b)};
endmodule
