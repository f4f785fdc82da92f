// An enumeration of bit begins as 0.
module t(input c, a, output logic [1:0] y); enum bit [1:0] {A,B,C} k; always_ff @(posedge c) if (a) k <= B; assign y = k; endmodule
