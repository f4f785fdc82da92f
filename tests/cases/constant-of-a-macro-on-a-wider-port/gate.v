module t(input [7:0] a, output [15:0] y, output [15:0] z); assign y = 16'd9; assign z = {8'd0, a}; endmodule
