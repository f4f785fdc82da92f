// The outputs of the new RTL come a clock later.
module t(input clk, input rst, input d, output reg q);
  always @(posedge clk) q <= rst ? 0 : d;
endmodule
