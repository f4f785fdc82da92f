module t(input clk, input rst, output y);
  reg [11:0] n;
  always @(posedge clk) if (rst) n <= 0;
  else n <= n + 1;
  assign y = &n;
endmodule
