module t(input a, b, s, output y);
  wire w;
  assign w = s ? a : 1'bz;
  assign w = s ? 1'bz : b;
  assign y = w;
endmodule
