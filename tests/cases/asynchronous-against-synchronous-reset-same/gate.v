module t(input clk, rst, d, output reg q);
  always @(posedge clk or posedge rst)
    if (!rst) q <= d;
    else q <= 0;
endmodule
