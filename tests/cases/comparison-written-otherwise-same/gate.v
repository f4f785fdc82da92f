module t(input clk, input rst, input [7:0] a, b, output reg eq, output neq);
  always @(posedge clk) eq <= ~|(a ^ b);
  assign neq = !eq;
endmodule
