module t(input clk, input a, output reg q);
  always @(posedge clk or negedge clk) q <= a;
endmodule
