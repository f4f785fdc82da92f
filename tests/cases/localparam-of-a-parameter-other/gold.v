// A localparam follows the parameter that it is made of.
module below #(parameter W = 2)(input [7:0] a, output [7:0] y);
  localparam M = (1 << W) - 1;
  assign y = a & M;
endmodule
module t(input [7:0] a, output [7:0] y);
  below #(5) u(a, y);
endmodule
