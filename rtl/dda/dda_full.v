// Whether a rate is 2^(W-1) or more in size, the source's 1 in the highest place: there normalising
// ends.
`default_nettype none

module dda_full #(
  parameter integer W = 16
) (
  input  wire [W:0] rate,
  output wire       full
);

  assign full = (rate[W] ^ rate[W-1]) | (rate[W] & ~|rate[W-2:0]);

endmodule

`default_nettype wire
