module t(input a, b, output y, z);
  assign y = a & ~b, z = 1'b0;
endmodule
