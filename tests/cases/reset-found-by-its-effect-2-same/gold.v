// The reset is the input that gives registers constants.
module t(input clk, input core_clear, input rst_busy, input a, output y);
  reg [2:0] s;
  always @(posedge clk) if (core_clear) s <= 1;
  else if (a) s <= {s[1:0], s[2]};
  assign y = s[2];
endmodule
