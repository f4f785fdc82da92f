// What one step does to a rate: a coefficient, 2 A, B or 2 C, is added or subtracted, modulo
// 2^(W+1). The source multiplies the point by them anew on each clock, in its scale converters.
`default_nettype none

module dda_change #(
  parameter integer W = 16
) (
  input  wire [W:0] rate,
  input  wire [W:0] by,
  // At most one of them is 1; with none the rate stays.
  input  wire       add,
  input  wire       subtract,
  output wire [W:0] result
);

  wire [W:0] term = ({W+1{add}} & by) | ({W+1{subtract}} & ~by);
  assign result = rate + term + {{W{1'b0}}, subtract};

endmodule

`default_nettype wire
