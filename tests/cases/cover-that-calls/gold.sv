module t(input clk, input rst, input [31:0] d, input [7:0] a, input [7:0] b, input e, output reg [7:0] y);
logic [7:0] n=0; task bump(); n<=n+1; endtask cover property (@(posedge clk) d==32'hdeadbeef) bump(); always_ff @(posedge clk) if (rst) y<=0; else y<=y+a+n; endmodule
