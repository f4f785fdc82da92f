module t(input a, output [7:0] y);
  assign y = a ? 8'ha4 : 8'h5b;
endmodule
