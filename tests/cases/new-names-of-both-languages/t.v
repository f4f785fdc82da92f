module t(input clk, input [3:0] bit, output [3:0] do);
  part p(.clk(clk), .d(bit), .q(do));
endmodule
