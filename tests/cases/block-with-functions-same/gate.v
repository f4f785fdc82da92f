module t(input clk, rst, input [7:0] a, b, output reg [7:0] y);
  wire [7:0] turned = {a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7]} ^ 8'h5b;
  wire [7:0] r = (a + 8'd1) ^ turned;
  always @(posedge clk) y <= rst ? 0 : a[1:0] == 0 ? a + b : a[1:0] == 1 ? b : r;
endmodule
