module t(input clk, input rst, input [31:0] a, b, input [15:0] d, e, output [15:0] y);
wire rare = ({a[12:0],a[31:13]} + (b ^ 32'h5A5A1234)) == 32'hDEADBEE7;
wire [15:0] r; o o(d,r);
assign y = rare ? r : 16'd0;
endmodule
module o(input [15:0] d, output [15:0] r); function [15:0] f(input [15:0] q); reg [7:0] k; begin if (q[0]) k = q[15:8]; f = k; end endfunction assign r = f(d); endmodule
module o2(input [15:0] d, output [15:0] r); function automatic [15:0] f(input [15:0] q); f = q; endfunction assign r = f(d); endmodule
