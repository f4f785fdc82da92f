// An asynchronous reset acts without a clock edge.
module t(input clk, rst, d, output reg q);
  always @(posedge clk or posedge rst)
    if (rst) q <= 0;
    else q <= d;
endmodule
