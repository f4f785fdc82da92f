module t(input [7:0] a, input [7:0] b, output [15:0] y); assign y={8'd0,~a}; endmodule
