// what the cells of a.lib are
module t(input [3:0] clkless, input ck, a, b, c, rn, s, e, output [13:0] y, output [1:0] fa, output [6:0] q, output qn);
assign y[0] = (a & b) | c; assign y[1] = (a | b) & ~c; assign y[2] = ~a ^ b; assign y[3] = ~(a & b) & c; assign y[4] = 1; assign y[5] = 0;
assign y[6] = ~a | (~b & c); assign y[7] = a ^ ~b; assign y[8] = a | (b & c); assign y[9] = a | (b ^ c); assign y[10] = (a ^ b) & c; assign y[11] = ~(a|b); assign y[12] = a; assign y[13] = a;
assign fa = a + b;
reg f0, f2, f3, f5; assign q = {2'b0, f5, f3, f2, a & b, f0}; assign qn = ~f0;
always @(posedge ck) f0 <= a; always @(posedge ck or negedge rn) if (!rn) f2 <= 0; else f2 <= a;
always @(posedge ck or posedge s) if (s) f3 <= 1; else f3 <= a;
always @(posedge ck) if (e) f5 <= b;
endmodule
