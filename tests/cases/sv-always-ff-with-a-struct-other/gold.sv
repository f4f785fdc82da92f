// A register that is a struct, reset member by member.
module t(input clk, rst_n, input [3:0] d, output [4:0] y);
  struct packed {
    logic [3:0] v;
    logic p;
  } r;
  always_ff @(posedge clk or negedge rst_n)
    if (!rst_n) r <= '{v: 4'd3, p: 1'b0};
    else r <= '{d + r.v, ^d};
  assign y = r;
endmodule
