module t(input clk, d, e, output reg q);
  always @(posedge clk) if (e) q <= d;
endmodule
