// int and byte are signed, bit vectors are not.
module t(input [7:0] a, output [1:0] y);
  byte b;
  bit [7:0] v;
  assign b = a;
  assign v = a;
  assign y = {b < 0, v < 0};
endmodule
