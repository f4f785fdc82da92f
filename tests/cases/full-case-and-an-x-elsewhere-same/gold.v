// A case that covers all values makes no latch, though an x stands in an expression.
module t(input [1:0] a, input s, output reg y, output [1:0] z);
  always @*
    case (s)
      1'b0: y = a[0];
      1'b1: y = a[1];
    endcase
  assign z = s ?
    2'bx1 : a;
endmodule
