module t(input clk, input rst, input a, b, input [3:0] d, e, output reg [3:0] q);
  always @(posedge clk) q <= rst ? 0 : a & b ? d | e : a ? d : b ? e : 0;
endmodule
