module t(input clk, input rst, input [31:0] a, b, input [15:0] d, e, output [15:0] y);
wire rare = ({a[12:0],a[31:13]} + (b ^ 32'h5A5A1234)) == 32'hDEADBEE7;
wire [15:0] r; function [15:0] f(input [15:0] v); reg [15:0] k; begin f = k; k = v; end endfunction
assign r = f(d);
assign y = rare ? r : 16'd0;
endmodule
