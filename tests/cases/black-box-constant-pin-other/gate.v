module t(input clk, a, output y);
  pll u(.i(a), .o(y), .r(1'b1));
endmodule
