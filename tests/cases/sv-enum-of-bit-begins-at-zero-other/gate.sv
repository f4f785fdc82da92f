module t(input c, a, output logic [1:0] y); enum logic [1:0] {A=1,B=2,C=3} k; always_ff @(posedge c) if (a) k <= B; assign y = k; endmodule
