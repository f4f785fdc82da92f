// A net inside with two tri-state drivers, of which one is always off.
module t(input a, b, s, output y);
  assign y = s ? a : b;
endmodule
