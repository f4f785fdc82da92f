module t(input a, output y);
  wire back;
  PLL p(.FEEDBACK_IN(back), .FEEDBACK_OUT(back), .Y(y), .A(a));
endmodule
