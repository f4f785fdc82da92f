// An integer is a signed register of 32 bits.
module t(input clk, rst, input [3:0] d, output y);
  integer n;
  always @(posedge clk)
    if (rst) n <= 0;
    else n <= n - d;
  assign y = n < -20;
endmodule
