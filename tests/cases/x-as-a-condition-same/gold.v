// Both branches of a condition x are merged bit by bit: what they share is known.
module t(input [1:0] a, output [1:0] y);
  assign y = 1'bx ? {a[1], 1'b0} : {a[1], 1'b1};
endmodule
