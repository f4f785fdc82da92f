// Asynchronous set and reset in one register: which one wins differs.
module t(input clk, rst, set, d, output reg y);
  always @(posedge clk or posedge rst or posedge set)
    if (rst) y <= 0;
    else if (set) y <= 1;
    else y <= d;
endmodule
