module t(input clk, input rst, output reg [3:0] q);
  initial q = 9;
  always @(posedge clk) if (rst) q <= 0;
  else q <= q + 1;
endmodule
