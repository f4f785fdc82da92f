module t(input clk, e, output reg [1:0] y);
  initial y = 1;
  always @(posedge clk) y <= y == 0 ? (e ? 1 : 0) : y == 1 ? 2 : 0;
endmodule
