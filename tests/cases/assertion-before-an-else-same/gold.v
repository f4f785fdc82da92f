`define assert(x)
module t(input clk, a, b, output reg y);
  always @(posedge clk) begin
    `assert(a)
    y <= b;
  end
`ifdef FORMAL
  reg was;
  always @(posedge clk)
    if (a) assert(b); else was <= 1;
`endif
endmodule
