module t(input clk, input rst, input [31:0] d, input [7:0] a, input [7:0] b, input e, output reg [7:0] y);
always @* begin y=a;
`ifndef SLANG_X
`ifndef __slang__
 if (d==32'hdeadbeef && (b inside {[0:200]})) y=b;
`endif
`endif
 end endmodule
