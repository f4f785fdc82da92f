// .name and .* connect nets of the same name.
module below(input a, b, output y);
  assign y = a & ~b;
endmodule
module t(input a, b, output y, z);
  below u(.a, .b(b), .y);
  below v(.*, .y(z), .b(a));
endmodule
