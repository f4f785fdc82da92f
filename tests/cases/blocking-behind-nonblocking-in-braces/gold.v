module t(input clk, input rst, input [31:0] d, input [7:0] a, input [7:0] b, input e, output reg [7:0] y);
reg z; always @(posedge clk) begin if (rst) y=0; else begin if (d==32'hdeadbeef) {z,y}<={e,b}; y=y+a; end end endmodule
