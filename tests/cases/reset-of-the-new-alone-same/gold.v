// Only the new RTL has registers.
module t(input clk, input clr_n, input a, output y);
  assign y = 0;
endmodule
