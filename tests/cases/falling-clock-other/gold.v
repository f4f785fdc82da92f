// A register that takes its value at the falling edge.
module t(input clk, rst, d, output reg q);
  always @(negedge clk)
    if (rst) q <= 0;
    else q <= d ^ q;
endmodule
