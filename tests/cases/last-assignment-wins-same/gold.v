// The last of two non-blocking assignments wins, bit by bit.
module t(input clk, rst, input [3:0] d, output reg [3:0] q);
  always @(posedge clk) begin
    q <= d;
    if (d[0]) q[2:1] <= 0;
    if (rst) q <= 0;
  end
endmodule
