module t(input clk, rst, set, d, output reg y);
  always @(posedge clk or posedge rst or posedge set)
    if (set) y <= 1;
    else if (rst) y <= 0;
    else y <= d;
endmodule
