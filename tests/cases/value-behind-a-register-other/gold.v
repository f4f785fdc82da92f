// As value-of-a-decoder-other, with the input a clock ago.
module t(input clk, input [31:0] i, input [3:0] a, b, output [15:0] y);
  reg [31:0] r;
  always @(posedge clk) r <= i;
  assign y = r == 32'h0badf00d ? {a, "", b} : a;
endmodule
