module t(input [1:0] i, output reg [7:0] y);
  always @* y = i == 3 ? 8'd0 : 8'h61 + i;
endmodule
