// Circular interpolator, SU 1665343: an arc of x^2 + y^2 = R^2 in the first quadrant,
// anticlockwise, one step a clock, to (0, R). The sector change takes one clock without a step. The
// numbers in parentheses are the source's blocks and pins.
//
// Inputs are sampled at the rising edge of clk; what they do, in order of precedence:
//   rst      clears everything: F to +0.75, CT7, CT8, T4 and T16 to 0. A step of that clock is
//            given all the same.
//   stop     the same, and no step is given on a clock with stop high. Works at any time.
//   load, start, sector2 are taken only while T4 = 0, alone or together on one clock; while an arc
//   runs they change nothing. A second load replaces the first. sector2 stays set until a clear.
//   A start with nothing loaded runs from the cleared state: a step in Y, the correction, a step in
//   X (the arc from (1, 0) with R^2 = 2).
//
// Each clock with T4 = 1 and stop low is one of
//   end         CT7 < 0: everything is cleared, no step. A start with CT7 < 0 (R = 0) ends so at
//               once.
//   correction  sector 1 and CT8 < 0 (22, 23): F and CT7 pass to sector 2, no step.
//   step        otherwise: step_y, step_x or both.
//
// Codes: f is floor(F) in two's complement, the fraction .75 is wired. ct7 and ct8 are ones'
// complement; the all-ones zero is stored as zero. Every register wraps modulo 2^width - 1, as
// addition with end-around carry does. An arc with round(R) < 2^W never wraps.
`default_nettype none

module circular #(
  // Bits of a coordinate, 2 to 32.
  parameter integer W = 16
) (
  input  wire         clk,      // stands in for the generator (5)
  input  wire         rst,

  // Start values
  input  wire         load,     // take f, ct7, ct8
  input  wire [W+1:0] f,        // (29) floor of the evaluation function
  input  wire [W:0]   ct7,      // (30) Y in sector 1, X - 1 in sector 2
  input  wire [W:0]   ct8,      // (31) X - Y - 1 in sector 1, X - Y in sector 2
  input  wire         sector2,  // (34) start in sector 2: Y >= X

  // Control
  input  wire         start,    // (33)
  input  wire         stop,     // (32) end of work and clear

  // Steps
  output wire         running,  // (4)
  output wire         step_y,   // (35) Y + 1
  output wire         step_x    // (36) X - 1
);

  // Elaboration stops here, on a module that does not exist, for a width out of range.
  generate
    if (W < 2 || W > 32) begin : g_width_out_of_range
      circular_needs_2_le_W_le_32 error ();
    end
  endgenerate

  // ---- Control: flip-flops (4) and (16), the gates of steps and of the sector change ------------
  wire         t4_q;
  wire         t16_q;
  wire [W+3:0] f_q;
  wire [W:0]   ct7_q;
  wire [W:0]   ct8_q;

  wire clear;
  wire take;
  wire step;
  wire down;        // T16 as the correction sets it: counter 7 counts down
  wire straight_y;  // (3)
  wire straight_x;  // (11)
  wire diagonal;    // (9)
  wire variant1;    // (22)
  wire variant2;    // (23)

  circular_control control (
    .clk(clk),
    .rst(rst),
    .load(load),
    .start(start),
    .stop(stop),
    .sector2(sector2),
    .f_negative(f_q[W+3]),
    .ct7_negative(ct7_q[W]),
    .ct8_negative(ct8_q[W]),
    .ct8_lowest(ct8_q[0]),
    .t4_q(t4_q),
    .t16_q(t16_q),
    .clear(clear),
    .take(take),
    .step(step),
    .down(down),
    .straight_y(straight_y),
    .straight_x(straight_x),
    .diagonal(diagonal),
    .variant1(variant1),
    .variant2(variant2)
  );

  // (27), (28): the steps of both sectors merged.
  assign step_y = step & (straight_y | diagonal);
  assign step_x = step & (straight_x | diagonal);
  assign running = t4_q;

  // ---- Counter of Y, then of X - 1 (7) ----------------------------------------------------------
  wire [W-1:0] ct7_pairs;
  wire         ct7_zero;

  circular_counter7 #(.W(W)) counter7 (
    .clk(clk),
    .clear(clear),
    .take(take),
    .ct7(ct7),
    .count(t4_q),
    .down(down),
    .two(variant2),
    .ct7_q(ct7_q),
    .ct7_pairs(ct7_pairs),
    .ct7_zero(ct7_zero)
  );

  // ---- Counter of X - Y - 1, then of X - Y (8) --------------------------------------------------
  wire [W-1:0] ct8_pairs;
  wire         ct8_zero_or_one;
  wire         ct8_falls;

  circular_counter8 #(.W(W)) counter8 (
    .clk(clk),
    .clear(clear),
    .take(take),
    .ct8(ct8),
    .count(t4_q),
    .two(diagonal),
    .variant1(variant1),
    .variant2(variant2),
    .ct8_q(ct8_q),
    .ct8_pairs(ct8_pairs),
    .ct8_zero_or_one(ct8_zero_or_one),
    .ct8_falls(ct8_falls)
  );

  // ---- Commutator (6), accumulator of F (1) -----------------------------------------------------
  wire [W+1:0] addend;
  wire         negative;

  circular_commutator #(.W(W)) commutator (
    .t16_q(t16_q),
    .ct7_q(ct7_q),
    .ct7_pairs(ct7_pairs),
    .ct7_zero(ct7_zero),
    .ct8_lowest(ct8_q[0]),
    .ct8_pairs(ct8_pairs),
    .ct8_zero_or_one(ct8_zero_or_one),
    .ct8_falls(ct8_falls),
    .channel1(diagonal),
    .channel2_down(straight_x | variant2),
    .channel3(straight_y),
    .addend(addend),
    .negative(negative)
  );

  circular_accumulator #(.W(W)) accumulator (
    .clk(clk),
    .clear(clear),
    .take(take),
    .add(t4_q),
    .f(f),
    .addend(addend),
    .negative(negative),
    .f_q(f_q)
  );

endmodule

`default_nettype wire
