// The states have other codes.
module t(input clk, input rst, output [5:0] q);
  reg [5:0] b;
  always @(posedge clk) if (rst) b <= 0;
  else b <= b + 1;
  assign q = b ^ (b >> 1);
endmodule
