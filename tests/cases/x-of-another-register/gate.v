module t(input clk, input [1:0] d, output y, z);
  reg \a+b ;
  always @(posedge clk) \a+b <= d[0];
  assign z = \a+b , y = d[0] ^ d[1];
endmodule
