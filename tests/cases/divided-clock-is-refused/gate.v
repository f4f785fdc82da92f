module t(input clk, rst, d, output reg q);
  reg half;
  always @(posedge clk) half <= rst ? 0 : ~half;
  always @(posedge clk) if (!half) q <= d;
endmodule
