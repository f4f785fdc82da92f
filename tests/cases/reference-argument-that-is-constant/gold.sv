module t(input clk, input rst, input [31:0] d, input [7:0] a, input [7:0] b, input e, output reg [7:0] y);
function automatic logic [7:0] f(const ref logic [7:0] x); return x+1; endfunction logic [7:0] n; always_comb begin n=a; y=f(n); end endmodule
