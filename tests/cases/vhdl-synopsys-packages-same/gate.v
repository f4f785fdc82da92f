module t(input clk, rst, input [7:0] d, output [7:0] q, output below, wide);
  reg [7:0] c = 0;
  always @(posedge clk)
    if (rst) c <= 0;
    else if (d > 77) c <= c + {{4{d[3]}}, d[3:0]};
    else c <= c - 1;
  assign q = c;
  assign below = c < {4'd0, d[3:0]};
  assign wide = $signed({1'b0, c}) < $signed(d);
endmodule
