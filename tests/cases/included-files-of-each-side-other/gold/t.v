module t(input [3:0] a, input [3:0] b, output [15:0] y);
  `include "body.vh"
endmodule
