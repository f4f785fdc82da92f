// A parameter of a black box is 2 and 4.
module t(input clk, a, output y);
  pll #(.D(2)) u(.i(a), .o(y));
endmodule
