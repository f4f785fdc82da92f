module t(input a, output y);
  wire feedback;
  PLL p(.A(a), .FEEDBACK_OUT(feedback), .FEEDBACK_IN(feedback), .Y(y));
endmodule
