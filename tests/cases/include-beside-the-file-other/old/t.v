`include "defs.vh"
module t(input a, output y);
  assign y = `OP a;
endmodule
