module t(input [1:0] a, output [3:0] q);
  assign q = 4'd1 + a;
endmodule
