// $clog2 of 0, 1, 8 and 9.
module t(input [3:0] a, output [15:0] y);
  assign y = {$clog2(0) + 4'd0, $clog2(1) + 4'd0} == 0 ? {a + $clog2(8), 3'd0} : 0;
endmodule
