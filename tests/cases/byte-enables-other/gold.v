// A write enable of each byte.
module t(input clk, input [1:0] be, a, input [15:0] d, output [15:0] q);
  reg [15:0] m [0:3];
  always @(posedge clk) begin
    if (be[0]) m[a][7:0] <= d[7:0];
    if (be[1]) m[a][15:8] <= d[15:8];
  end
  assign q = m[a];
endmodule
