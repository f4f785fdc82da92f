module t(input clk, ld, d, e, output reg q);
  always @(posedge clk)
    if (ld) q <= d;
    else q <= e;
endmodule
