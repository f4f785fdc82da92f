// The variable k of the function keeps its value where en is 0.
module t(input clk, rst, en, input [3:0] a, output reg [3:0] q);
  function [3:0] held(input [3:0] v, input e);
    reg [3:0] k;
    begin
      if (e) k = v;
      held = k;
    end
  endfunction
  always @(posedge clk)
    if (rst) q <= held(4'd0, 1'b1);
    else q <= held(a, en);
endmodule
