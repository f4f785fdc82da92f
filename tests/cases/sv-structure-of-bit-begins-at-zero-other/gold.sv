// The members of the structure begin as 0, and logic as x.
typedef struct packed { bit [1:0] x; bit [1:0] z; } s;
module t(input c, a, output logic [3:0] y); s k; always_ff @(posedge c) if (a) k.x <= 1; assign y = k; endmodule
