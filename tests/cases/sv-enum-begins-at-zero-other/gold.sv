// An enumeration of int begins as 0, and logic as x.
module t(input c, a, output logic [1:0] y); typedef enum {A,B,C} e; e k; always_ff @(posedge c) if (a) k <= B; assign y = k; endmodule
