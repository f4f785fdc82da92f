package p; typedef bit b; typedef b [3:0] n; endpackage
module t(input c, a, output logic [3:0] y); logic [3:0] k; always_ff @(posedge c) if (a) k <= 1; assign y = k; endmodule
