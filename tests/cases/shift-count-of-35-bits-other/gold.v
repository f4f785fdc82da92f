// A count of 32 and more is more, and not its lower bits.
module t(input [7:0] a, input [34:0] n, output [7:0] y);
  assign y = a << n;
endmodule
