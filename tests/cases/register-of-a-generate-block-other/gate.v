module t(input clk, rst, input [2:0] d, output y);
  reg [2:0] r;
  always @(posedge clk) r <= rst ? 0 : d;
  assign y = r[0] ^ r[1];
endmodule
