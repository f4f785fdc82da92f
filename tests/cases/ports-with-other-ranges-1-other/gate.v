module t(input clk, input rst, input [7:4] a, output [4:1] y, output [0:2] z);
  reg [5:2] r;
  always @(posedge clk) r <= a;
  assign y = {r[4:2], 1'b1}, z = {r[2], 1'b0, r[3]};
endmodule
