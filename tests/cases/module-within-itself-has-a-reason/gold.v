// A module instantiates itself: the message has a reason.
module t(input a, output y);
  t u(a, y);
endmodule
