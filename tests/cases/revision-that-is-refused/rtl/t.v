module t(input clk, input d, output reg q);
  always @(posedge clk) begin if (d) #1; q <= d; end
endmodule
