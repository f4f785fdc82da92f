// An x is any value, however rare, but one value wherever it is read.
module t(input clk, input rst, input d, output reg y);
  reg [15:0] x, z;
  always @(posedge clk) begin
    x <= 16'bx;
    z <= x;
    y <= x == 16'ha5c3 && z == 16'h1234;
  end
endmodule
