// An enumeration of bit begins as 0, and one of logic as x.
module t(input c, a, output logic [1:0] y); enum bit [1:0] {A=1,B=2,C=3} k; always_ff @(posedge c) if (a) k <= B; assign y = k; endmodule
