// A net wor is the OR of its drivers.
module t(input a, b, output y);
  wor w;
  assign w = a;
  assign w = b;
  assign y = w;
endmodule
