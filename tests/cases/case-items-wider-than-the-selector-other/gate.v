module t(input [1:0] s, output reg [1:0] y);
  always @* y = s == 2 ? 2'd1 : 2'd3;
endmodule
