module t(input [1:0] s, output reg y);
  always @* y = s == 1;
endmodule
