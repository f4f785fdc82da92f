// A shift register.
module t(input clk, input rst, input signed [15:0] a, input [3:0] n, output reg signed [15:0] q);
  reg [3:0] m;
  always @(posedge clk) begin
    m <= n;
    q <= a >>> m;
  end
endmodule
