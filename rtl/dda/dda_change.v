// What one step does to a rate: a coefficient is added or subtracted, modulo 2^(W+1).
`default_nettype none

module dda_change #(
  parameter integer W = 16
) (
  input  wire [W:0] value,
  input  wire [W:0] by,
  input  wire       add,
  input  wire       subtract,
  output wire [W:0] result
);

  wire [W:0] term = ({W+1{add}} & by) | ({W+1{subtract}} & ~by);
  assign result = value + term + {{W{1'b0}}, subtract};

endmodule

`default_nettype wire
