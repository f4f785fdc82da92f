// The result of the function keeps its value from call to call where w is 0.
module t(input clk, a, b, output reg y);
  function f(input x, input w);
    if (w) f = x;
  endfunction
  always @(posedge clk) y <= f(a, b);
endmodule
