module t(input clk, rst, input [3:0] d, output reg [3:0] q);
  always @(posedge clk) q <= {4{~rst}} & d & ~{1'b0, {2{d[0]}}, 1'b0};
endmodule
