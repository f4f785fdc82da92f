module t(input a, input [31:0] d, output y);
  assign y = a;
endmodule
