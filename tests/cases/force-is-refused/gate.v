module t(input clk, d, e, output reg q);
  always @(posedge clk) q <= d;
endmodule
