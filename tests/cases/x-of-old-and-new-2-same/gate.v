module t(input clk, input rst, input s, output reg [1:0] q);
  always @(posedge clk) if (s) q <= 1;
  else q <= 2'bx;
endmodule
