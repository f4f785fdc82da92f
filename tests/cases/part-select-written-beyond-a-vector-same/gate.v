module t(input [2:0] n, input [3:0] d, output reg [7:0] y);
  wire [10:0] m = 11'hf << n, v = d << n;
  always @* y = (8'hff & ~m) | v;
endmodule
