`include "../config/config.vh"
module core(input clk, input [`W-1:0] d, output [`W-1:0] q);
  keeps #(.W(`W)) keep(clk, d, q);
endmodule
