module t(input clk, input [31:0] d, output reg q);
  reg last = 0;
  function [31:0] shown(input [31:0] v);
    begin
      last = v[0];
      shown = v;
    end
  endfunction
  always @(posedge clk) begin
    if (d == 32'hdeadbeef) $display("%h", shown(d));
    q <= last;
  end
endmodule
