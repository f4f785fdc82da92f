module t(input [7:0] d, output q);
  assign q = d[0] | d[1] | d[2];
endmodule
