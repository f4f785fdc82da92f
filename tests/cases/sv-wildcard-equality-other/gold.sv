// ==? takes x in its right operand as a wildcard.
module t(input [3:0] a, output y);
  assign y = a ==? 4'b1x0x;
endmodule
