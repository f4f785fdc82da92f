module t(input a, b, output y);
  select u(.i(a), .k(b), .o(y));
endmodule
module select(input i, j, k, output o);
  assign o = j ? k : i;
endmodule
