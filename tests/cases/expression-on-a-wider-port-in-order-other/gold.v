module ps(input [8:0] x, output [15:0] y); assign y=x; endmodule
module t(input [7:0] a, input [7:0] b, output [15:0] y); ps u(a + b, y); endmodule
