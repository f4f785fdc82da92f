module t(input clk, rst, input [7:0] d, output reg [7:0] y);
  reg [7:0] p, q;
  always @(posedge clk)
    if (rst) begin
      p <= 0;
      q <= 0;
      y <= 0;
    end else begin
      p <= d;
      q <= p;
      y <= q + p;
    end
endmodule
