`include "op.vh"
module t(input [3:0] a, b, output [3:0] y);
  assign y = a `OP b;
endmodule
