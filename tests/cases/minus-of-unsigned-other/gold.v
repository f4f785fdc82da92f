// The negative of an unsigned value is unsigned and never below 0.
module t(input [3:0] a, output y);
  assign y = -a < 1;
endmodule
