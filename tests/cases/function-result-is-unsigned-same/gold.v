// The result of a function without signed is unsigned.
module t(input signed [3:0] a, output [7:0] y);
  function [3:0] same(input signed [3:0] v);
    same = v;
  endfunction
  assign y = same(a);
endmodule
