module t(input [7:0] a, input [7:0] b, input e, output [15:0] y); reg [15:0] r; task f(input [8:0] x); r=x; endtask always @* f(a+b); assign y=r; endmodule
