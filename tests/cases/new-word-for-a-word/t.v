module t #(parameter W = 4, MODE = "slow")(input clk, input rst, input [W-1:0] a, output reg [W-1:0] q);
  always @(posedge clk) if (rst) q <= 0; else q <= a;
endmodule
