module t(input a, b, output y, z);
  assign y = a & ~b, z = a & ~b;
endmodule
