module t(input clk, input [4:0] d, output reg [4:0] q);
  always @(posedge clk) q <= d >> 1 | d << 4;
endmodule
