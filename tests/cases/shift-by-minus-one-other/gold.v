// -1 as a count is 2^32 - 1.
module t(input [7:0] a, output [7:0] y);
  assign y = a << -1;
endmodule
