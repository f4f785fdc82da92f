// Only the bits within the vector are written.
module t(input [2:0] n, input [3:0] d, output reg [7:0] y);
  always @* begin
    y = 8'hff;
    y[n +: 4] = d;
  end
endmodule
