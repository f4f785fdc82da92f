module t(input clk, input rst, input [7:0] a, input [7:0] b, input [2:0] s, input [3:0] c, input e, input [31:0] d, output [15:0] y);
wire [3:0] k=4'd1+a[3:0]; assign y={4'd1,k,4'd3,4'd2}; endmodule
