// A net without a driver in the new RTL.
module t(input a, output y);
  assign y = a;
endmodule
