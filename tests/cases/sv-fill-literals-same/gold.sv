// '1 takes the width of its context, in an expression too.
module t(input [7:0] a, input [39:0] b, output [7:0] y, output z);
  assign y = a ^ '1;
  assign z = b == '1;
endmodule
