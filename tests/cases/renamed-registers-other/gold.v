// The registers have other names in the new RTL.
module t(input clk, rst, input [7:0] d, output reg [7:0] y);
  reg [7:0] first, second;
  always @(posedge clk)
    if (rst) begin
      first <= 0;
      second <= 0;
      y <= 0;
    end else begin
      first <= d;
      second <= first;
      y <= second + first;
    end
endmodule
