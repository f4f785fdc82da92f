// The type is one of bits, which begin as 0, and logic as x.
package p; typedef bit b; typedef b [3:0] n; endpackage
module t(input c, a, output logic [3:0] y); p::n k; always_ff @(posedge c) if (a) k <= 1; assign y = k; endmodule
