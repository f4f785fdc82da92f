module t(input clk, input rst, input we, input [11:0] w, r, input [31:0] d, output reg [31:0] q);
  reg [31:0] other[0:1];
  always @(posedge clk) begin
    if (we) other[w] <= d;
    q <= other[r];
  end
endmodule
