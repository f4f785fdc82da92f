module t(input signed [1:0] s, output reg y);
  always @* y = ~s[0] & s[0];
endmodule
