// A register is loaded from an input while ld is high, whatever the clock does.
module t(input clk, ld, d, e, output reg q);
  always @(posedge clk or posedge ld)
    if (ld) q <= d;
    else q <= e;
endmodule
