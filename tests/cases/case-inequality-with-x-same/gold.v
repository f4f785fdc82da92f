// ^a !== 1'bx is 1 where a is known.
module t(input [3:0] a, input b, c, output y);
  assign y = c;
endmodule
