// Constants of more than 32 bits, and one that is cut.
module t(input [69:0] a, output [69:0] y);
  assign y = a ^ 70'h3f_0000_0001_0000_0003 ^ 4'd19;
endmodule
