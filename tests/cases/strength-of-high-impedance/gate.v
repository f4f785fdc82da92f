module t(input a, input [31:0] d, output y);
  wire w;
  assign (strong0, highz1) w = d == 32'h600dcafe;
  assign y = a ^ w;
endmodule
