// supply1 is 1, supply0 is 0.
module t(input a, output y);
  supply1 one;
  supply0 zero;
  assign y = one ? a : zero;
endmodule
