// Both ports write one word: the later statement wins.
module t(input clk, v, w, input [1:0] a, b, r, input [3:0] d, e, output [3:0] q);
  reg [3:0] m [0:3];
  always @(posedge clk) begin
    if (v) m[a] <= d;
    if (w) m[b] <= e;
  end
  assign q = m[r];
endmodule
