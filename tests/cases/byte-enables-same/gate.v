module t(input clk, input [1:0] be, a, input [15:0] d, output [15:0] q);
  reg [7:0] h [0:3], l [0:3];
  always @(posedge clk) begin
    if (be[0]) l[a] <= d[7:0];
    if (be[1]) h[a] <= d[15:8];
  end
  assign q = {h[a], l[a]};
endmodule
