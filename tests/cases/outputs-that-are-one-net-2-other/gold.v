// Two outputs of one net.
module t(input clk, input rst, input d, output y, z);
  assign y = d, z = ~d;
endmodule
