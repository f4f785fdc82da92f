module t(input [2:0] n, input [3:0] d, output reg [7:0] y);
  always @* y = n > 4 ? 8'hff : (8'hff & ~(8'hf << n)) | (d << n);
endmodule
