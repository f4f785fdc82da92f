// An unsized constant has 32 bits, so the sum keeps its carry.
module t(input [7:0] a, b, output [7:0] y);
  assign y = (a + b + 0) >> 1;
endmodule
