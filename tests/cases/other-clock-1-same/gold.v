// Registers of another clock, and a clock of another name.
module t(input a, b, d, output reg q);
  always @(posedge a) q <= d;
endmodule
