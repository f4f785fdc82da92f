module t(input clk, input rst, input [31:0] d, input [7:0] a, input [7:0] b, input e, output reg [7:0] y);
logic [7:0] n; always_comb begin n=a; if (d==32'hdeadbeef) $display("%0d",n++); y=n; end endmodule
