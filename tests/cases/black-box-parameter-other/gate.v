module t(input clk, a, output y);
  pll #(.D(4)) u(.i(a), .o(y));
endmodule
