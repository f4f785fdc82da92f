// The variable sum of the function keeps its value from call to call.
module t(input logic clk, input logic [7:0] a, output logic [7:0] q);
  function logic [7:0] f(input logic [7:0] x);
    static logic [7:0] sum = 0;
    sum = sum + x;
    return sum;
  endfunction
  always_ff @(posedge clk) q <= f(a);
endmodule
