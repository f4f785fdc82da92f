// A width is worked out by a function.
module t(input [7:0] a, output [3:0] y);
  function integer bits(input integer n);
    for (bits = 0; n > 0; bits = bits + 1) n = n >> 1;
  endfunction
  wire [bits(9)-1:0] low = a;
  assign y = low;
endmodule
