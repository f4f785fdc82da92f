module t(input clk, input rst, input [31:0] d, input [7:0] a, input [7:0] b, output logic [7:0] y);
function automatic void bump(ref logic [7:0] x, input [7:0] z); x=x+z; endfunction
always_comb begin y=a; if (d==32'hdeadbeef) bump(y,b); end endmodule
