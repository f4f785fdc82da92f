module t(input clk, rst_n, srst, input [3:0] d, output reg [3:0] q, r);
  always @(posedge clk or negedge rst_n)
    if (!rst_n) {q, r} <= 8'h03;
    else if (srst) {q, r} <= 8'h03;
    else if (d[1:0] != 0) {q, r} <= {d, q};
endmodule
