// The clock of a register is made of two inputs.
module t(input clk, en, d, output reg q);
  wire gated = clk & en;
  always @(posedge gated) q <= d;
endmodule
