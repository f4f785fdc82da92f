// A z is 0 in Verilator, and any value in the cells: Verilator is no judge of it.
package p; typedef struct packed {logic [3:0] a; logic b;} s_t; endpackage
module t import p::*; (input logic clk, e, input s_t d, output s_t q);
  wire [3:0] w = e ? d.a : 'z;
  assign q = '{a: w + 1, b: d.b};
endmodule
