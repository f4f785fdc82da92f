// Two drivers of y in the new RTL: x where they differ.
module t(input a, b, output y);
  assign y = b;
endmodule
