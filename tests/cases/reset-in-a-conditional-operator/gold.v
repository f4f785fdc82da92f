// The reset is in a conditional operator: read, or refused with the line or the name.
module t(input clk, rst, d, output reg q);
  always @(posedge clk or posedge rst) q <= rst ? 1'b0 : d;
endmodule
