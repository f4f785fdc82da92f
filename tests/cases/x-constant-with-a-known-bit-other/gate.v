module t(input a, output [7:0] y);
  assign y = {8{a}};
endmodule
