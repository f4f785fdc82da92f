module t(input [1:0] a, output [3:0] q);
  assign q = 4'd4 - a;
endmodule
