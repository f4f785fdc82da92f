module t(input clk, d, output reg [1:0] q);
  reg [1:0] n = 0;
  always @(posedge clk) if (d) n <= n + 1;
  always @* q = n;
endmodule
