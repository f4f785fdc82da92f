// Two old ports are mapped to one new port.
module t(input a, b, output y);
  assign y = a & ~b;
endmodule
