module t(input a, b, c, output [3:0] y);
  assign y = {~a, a ^ b ^ c, ~(a | b | c), ~(a & b & c)};
endmodule
