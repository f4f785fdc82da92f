// y does not follow b.
module t(input a, b, output reg y);
  always @(a) y = a & b;
endmodule
