// The clock of a register is another register.
module t(input clk, rst, d, output reg q);
  reg half;
  always @(posedge clk) half <= rst ? 0 : ~half;
  always @(posedge half) q <= d;
endmodule
