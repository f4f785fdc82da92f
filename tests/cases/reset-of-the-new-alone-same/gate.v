module t(input clk, input clr_n, input a, output y);
  reg q;
  always @(posedge clk) if (!clr_n) q <= 0;
  else q <= q & a;
  assign y = q;
endmodule
