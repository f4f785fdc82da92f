`include "on.vh"
module t(input a, output y);
  INV i(.A(a), .Y(y));
endmodule
