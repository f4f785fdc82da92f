module t #(parameter integer W = 8, parameter [7:0] K = 8'h5b)
  (input clk, rst, input [W-1:0] a, b, output reg [W-1:0] y);
  localparam integer LAST = W - 1;
  integer i;
  function [W-1:0] turned(input [W-1:0] x);
    for (i = 0; i <= LAST; i = i + 1) turned[i] = x[LAST - i] ^ K[i];
  endfunction
  function [W-1:0] mixed;
    input [W-1:0] x;
    reg [W-1:0] b;
    begin
      b = x + 1;
      mixed = b ^ turned(x);
    end
  endfunction
  function [W-1:0] both(input [W-1:0] x);
    both = x + b;
  endfunction
  reg [W-1:0] r, s;
  always @* r = mixed(a);
  always @*
    case (a[1:0])
      0: s = both(a);
      1: s = b;
      default: s = r;
    endcase
  always @(posedge clk) y <= rst ? 0 : s;
endmodule
