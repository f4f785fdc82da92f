module t(input [1:0] sel, input [3:0] a, b, output reg [3:0] y);
  always @* y = a;
endmodule
