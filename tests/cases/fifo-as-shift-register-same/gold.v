// A FIFO as a memory and as a shift register.
module t(input clk, input rst, input push, pop, input [1:0] d, output [1:0] q, output empty, full);
  reg [1:0] m[0:3];
  reg [2:0] w, r;
  assign empty = w == r, full = w == {~r[2], r[1:0]};
  assign q = empty ? 0 : m[r[1:0]];
  always @(posedge clk) if (rst) begin
    w <= 0;
    r <= 0;
  end else begin
    if (push && !full) begin
      m[w[1:0]] <= d;
      w <= w + 1;
    end
    if (pop && !empty) r <= r + 1;
  end
endmodule
