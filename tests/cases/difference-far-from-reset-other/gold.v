// The counter is full 4,095 clocks after the reset.
module t(input clk, input rst, output y);
  reg [11:0] n;
  always @(posedge clk) if (rst) n <= 0;
  else n <= n + 1;
  assign y = 0;
endmodule
