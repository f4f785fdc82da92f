module t(input clk, input rst, input [31:0] a, b, input [15:0] d, e, output [15:0] y);
wire rare = ({a[12:0],a[31:13]} + (b ^ 32'h5A5A1234)) == 32'hDEADBEE7;

assign y = rare ? {15'd0, d[3:0] + e[3:0] > 3.0} : 16'd0;
endmodule
