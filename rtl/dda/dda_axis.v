// The adder of one accumulator, SX or SY. The sum of S and a rate >= 0 is 2^W or more where there
// is a carry: a step of +1. With a rate below 0 it is negative where there is none, a borrow: a
// step of -1. The sum goes on modulo 2^W, whether the axis may step or not.
`default_nettype none

module dda_axis #(
  parameter integer W = 16
) (
  input  wire [W-1:0] s,
  input  wire [W:0]   rate,      // two's complement
  input  wire         may_step,
  output wire [W-1:0] next_s,
  output wire         up,
  output wire         down
);

  wire carry;
  assign {carry, next_s} = {1'b0, s} + {1'b0, rate[W-1:0]};
  assign up   = may_step & carry & ~rate[W];
  assign down = may_step & ~carry & rate[W];

endmodule

`default_nettype wire
