module t(input [7:0] a, output reg [7:0] y);
  wire [7:0] b = {a[6:0], a[7] ^ a[0]};
  wire [7:0] c = {b[6:0], b[7] ^ b[0]};
  always @* y = c + 2;
endmodule
