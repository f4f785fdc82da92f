module t(input clk, rst, en, input [3:0] a, output reg [3:0] q);
  always @(posedge clk)
    if (rst) q <= 0;
    else q <= en ? a : 4'd5;
endmodule
