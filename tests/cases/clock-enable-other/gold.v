// An enable beside a reset: which one wins.
module t(input clk, rst, en, d, output reg q);
  always @(posedge clk)
    if (rst) q <= 0;
    else if (en) q <= d;
endmodule
