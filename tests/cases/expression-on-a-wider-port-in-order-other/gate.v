module t(input [7:0] a, input [7:0] b, output [15:0] y); wire [7:0] k=a+b; assign y=k; endmodule
