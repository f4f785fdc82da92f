module t(input clk, rst, input [7:0] a, b, output reg [7:0] y);
  reg [15:0] k;
  function [7:0] g(input [7:0] i);
    g = k[14:1] == 14'h1234 ? i ^ b : i;
  endfunction
  function [7:0] f(input [7:0] i);
    f = g(i) + 1;
  endfunction
  reg [7:0] r;
  always @*
    if (rst) r = 0;
    else r = f(a);
  always @(posedge clk)
    if (rst) begin
      k <= 0;
      y <= 0;
    end else begin
      k <= k + 1;
      y <= r;
    end
endmodule
