// A count of 33 bits is more than any width: the result is 0.
module t(input [7:0] a, output [7:0] y);
  assign y = a >> 33'h0_ffff_ffff;
endmodule
