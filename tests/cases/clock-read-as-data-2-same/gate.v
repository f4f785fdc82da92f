module t(input clk, input rst, input d, output reg q, output y);
  always @(posedge clk) q <= d;
  assign y = d;
endmodule
