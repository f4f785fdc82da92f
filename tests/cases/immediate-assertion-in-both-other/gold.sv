// Both sides have an immediate assertion beside the register.
module t(input clk, rst, a, b, output reg y);
  always @(posedge clk)
    if (rst) y <= 0;
    else y <= a & b;
  always @* assert (y == 0 || a);
endmodule
