module t(input [2:0] s, output reg [1:0] y);
  always @* y = s[1] ? 2'd2 : 2'd3;
endmodule
