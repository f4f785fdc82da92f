module t(input a, output y);
  wire n;
  assign y = a & n;
endmodule
