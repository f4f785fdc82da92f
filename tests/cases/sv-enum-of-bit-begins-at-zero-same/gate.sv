module t(input c, a, output logic [1:0] y); logic [1:0] k = 0; always_ff @(posedge c) if (a) k <= 1; assign y = k; endmodule
