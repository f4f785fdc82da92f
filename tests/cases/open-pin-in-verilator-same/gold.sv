// An open input has any value in both.
package p; typedef struct packed {logic [3:0] a; logic b;} s_t; endpackage
module sub import p::*; (input logic clk, input s_t d, input logic e, output s_t q);
  always_ff @(posedge clk) q <= '{a: d.a + 1, b: d.b ^ e};
endmodule
module t import p::*; (input logic clk, input s_t d, output s_t q);
  sub u(.clk, .d, .e(), .q);
endmodule
