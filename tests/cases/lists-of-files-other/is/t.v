`include "width.vh"
module t(input [`W-1:0] a, b, output [`W-1:0] y);
  adder #(.W(`W)) sum(a, b, y);
endmodule
