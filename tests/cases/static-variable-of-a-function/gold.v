// The variable s of the function keeps its value from call to call.
module t(input clk, d, output reg q);
  function keep(input v);
    reg s;
    begin
      s = s | v;
      keep = s;
    end
  endfunction
  always @(posedge clk) q <= keep(d);
endmodule
