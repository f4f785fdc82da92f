module t(input clk, input rst, input [31:0] d, input [7:0] a, input [7:0] b, input e, output reg [7:0] y);
always @(posedge clk) if (rst) y=0; else y=y+a; endmodule
