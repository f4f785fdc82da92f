// The block wakes at the rising edge of rst and resets while it is low.
module t(input clk, rst, output reg q);
  always @(posedge clk or posedge rst)
    if (!rst) q <= 0;
    else q <= ~q;
endmodule
