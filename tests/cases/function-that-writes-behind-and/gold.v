// count writes seen, and is called only where d has its rare value.
module t(input clk, rst, input [31:0] d, output reg q);
  reg seen;
  function count(input [31:0] v);
    begin
      seen = v[0];
      count = v[1];
    end
  endfunction
  always @(posedge clk)
    if (rst) begin
      seen = 0;
      q <= 0;
    end else begin
      if (d == 32'hdeadbeef && count(d)) q <= 1;
      else q <= seen;
    end
endmodule
