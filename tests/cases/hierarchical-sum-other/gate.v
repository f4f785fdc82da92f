module t(input clk, rst, output [3:0] y);
  reg [3:0] n;
  always @(posedge clk)
    if (rst) n <= 0;
    else n <= n + 3;
  assign y = n[0] + 1;
endmodule
