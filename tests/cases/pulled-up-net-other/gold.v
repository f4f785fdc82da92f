// A net tri1 is 1 where nothing drives it.
module t(input a, s, output y);
  tri1 w;
  assign w = s ? a : 1'bz;
  assign y = w;
endmodule
