// A function of a constant that writes beyond the end: yosys crashes; slang has to take it.
module t(input [4:0] d, output [4:0] y);
  function [4:0] f(input [3:0] a);
    begin
      f = {a, 1'b0};
      f[a] = 1'b1;
      f[4'hd +: 2] = 2'b11;
    end
  endfunction
  assign y = d ^ f(4'd9);
endmodule
