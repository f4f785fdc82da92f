`define SUM(x, y) ((x) + (y))
`define TWICE `SUM(a, a)
module ps(input [8:0] x, output [15:0] y); assign y = x; endmodule
module t(input [7:0] a, input [7:0] b, output [15:0] y, output [15:0] z);
  ps u(.x(`SUM(a, b)), .y(y));
  ps v(.x(`TWICE), .y(z));
endmodule
