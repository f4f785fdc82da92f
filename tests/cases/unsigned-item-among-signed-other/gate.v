module t(input signed [1:0] s, output reg [1:0] y);
  always @* y = s == 1 ? 2'd2 : &s ? 2'd1 : 2'd0;
endmodule
