module t(input clk, input rst, input d, output reg y);
  reg [15:0] x, z;
  always @(posedge clk) begin
    x <= 16'bx;
    z <= x;
    y <= 1;
  end
endmodule
