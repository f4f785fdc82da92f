// The old RTL leaves an operand of & below open: x, so any value will do.
module t(input a, b, output y);
  below u(.i(a), .o(y));
endmodule
module below(input i, j, output o);
  assign o = i & j;
endmodule
