module t(input clk, rst, input [3:0] d, output reg [3:0] q, p);
  always @(posedge clk)
    if (rst) {q, p} <= 0;
    else begin
      q <= (p + d) ^ d;
      p <= p + d;
    end
endmodule
