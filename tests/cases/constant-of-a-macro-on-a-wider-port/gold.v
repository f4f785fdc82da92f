`define LOW 4'd9
module ps(input [8:0] x, output [15:0] y); assign y = x; endmodule
module t(input [7:0] a, output [15:0] y, output [15:0] z); ps u(.x(`LOW), .y(y)); ps v(.x(a), .y(z)); endmodule
