// An argument is cut or extended to the width of the input.
module t(input signed [3:0] a, output [7:0] y);
  function [7:0] widened(input signed [5:0] v);
    widened = v;
  endfunction
  assign y = widened(a) + widened(8'h7f);
endmodule
