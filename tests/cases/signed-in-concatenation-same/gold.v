// A concatenation is unsigned.
module t(input [3:0] a, output [7:0] y);
  assign y = {$signed(a)};
endmodule
