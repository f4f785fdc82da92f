// A memory of two dimensions.
module t(input clk, rst, we, input [1:0] i, input j, input [3:0] d, output [3:0] q);
  reg [3:0] m [0:3][0:1];
  integer x, z;
  always @(posedge clk)
    if (rst) begin
      for (x = 0; x < 4; x = x + 1) for (z = 0; z < 2; z = z + 1) m[x][z] <= 0;
    end else if (we) m[i][j] <= d;
  assign q = m[i][j];
endmodule
