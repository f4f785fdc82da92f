module t(input a, b, output reg y);
  always @* y = a & b;
endmodule
