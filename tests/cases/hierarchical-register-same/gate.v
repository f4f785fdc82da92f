module t(input clk, rst, output [1:0] y);
  reg [1:0] n;
  always @(posedge clk)
    if (rst) n <= 0;
    else n <= n + 1;
  assign y = n;
endmodule
