module t(input clk, e, output reg [2:0] y);
  initial y = 0;
  always @(posedge clk) if (e) y <= y == 6 ? 2 : y + 1;
endmodule
