// a === 1'bx is 0 where a is known.
module t(input a, b, c, output y);
  assign y = (a === 1'bx) ? b : c;
endmodule
