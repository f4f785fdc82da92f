// A net wand is the AND of its drivers.
module t(input a, b, output y);
  wand w;
  assign w = a;
  assign w = b;
  assign y = w;
endmodule
