module t(input clk, input rst, input signed [2:0] i, input [7:0] d, output reg [7:0] q, p);
  wire [2:0] n = i;
  wire [7:0] mask = i < 0 ? 8'd0 : 8'd3 << n;
  always @(posedge clk)
    if (rst) begin
      q <= 0;
      p <= 0;
    end
    else begin
      q <= d << n;
      p <= (p & ~mask) | (d[1:0] << n & mask);
    end
endmodule
