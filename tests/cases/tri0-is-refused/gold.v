// An open input is 0.
module t(input clk, input en, d, output reg q);
  tri0 line;
  assign line = en ? d : 1'bz;
  always @(posedge clk) q <= line;
endmodule
