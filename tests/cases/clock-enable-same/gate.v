module t(input clk, rst, en, d, output reg q);
  always @(posedge clk) q <= rst ? 1'b0 : en ? d : q;
endmodule
