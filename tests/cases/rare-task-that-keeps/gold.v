module t(input clk, input rst, input [31:0] a, b, input [15:0] d, e, output [15:0] y);
wire rare = ({a[12:0],a[31:13]} + (b ^ 32'h5A5A1234)) == 32'hDEADBEE7;
reg [15:0] r; task f(input [15:0] q, output [7:0] o); reg [7:0] k; begin if (q[0]) k = q[15:8]; o = k; end endtask always @* begin r = 0; f(d, r[7:0]); end
assign y = rare ? r : 16'd0;
endmodule
