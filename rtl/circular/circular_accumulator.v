// Accumulator (1): the evaluation function F in ones' complement with two fraction bits, added to
// with end-around carry. Its sign decides the step.
//
// F keeps the fraction .75 (code 11, or 10 where F is negative), so a load is never zero; and a sum
// with end-around carry is +0 only where both terms are. The code of +0 therefore never occurs. A
// sum that wraps may be -0, all ones, and counts as negative.
//
// A carry that went all round would run through the sum twice, one run after the other. Here each
// half of the sum is made with and without a carry into it, all at once, and two carries select.
`default_nettype none

module circular_accumulator #(
  parameter integer W = 16
) (
  input  wire         clk,
  input  wire         clear,
  input  wire         take,
  input  wire         add,
  input  wire [W+1:0] f,         // (29) floor(F), two's complement
  input  wire [W+1:0] addend,    // (6) whole steps, ones' complement
  input  wire         negative,  // the sign of addend, told early
  output reg  [W+3:0] f_q
);

  // Bits of the lower and the higher half. The lower is small, for the low bits of addend are late.
  localparam integer L = 4;
  localparam integer H = W + 4 - L;

  // The fraction bits of a whole number repeat its sign.
  wire [W+3:0] term = {addend, {2{negative}}};
  wire [W+3:0] loaded = {f, 1'b1, ~f[W+1]};

  // a + b + 1 is a - not b.
  wire [L:0] low = {1'b0, f_q[L-1:0]} + {1'b0, term[L-1:0]};
  wire [L:0] low_more = {1'b0, f_q[L-1:0]} - {1'b1, ~term[L-1:0]};

  // The lower half gives a carry by itself, or passes one on, or does neither. One more digit above
  // the higher half, 1 + 1, 1 + 0 or 0 + 0, makes the carry out of it the one that goes into it.
  // Where the start values are taken there is one, and they stand in the place of the sum with it.
  wire gives = take | low[L];
  wire passes = take | low_more[L];
  wire [H+1:0] high = {1'b0, passes, f_q[W+3:L]} + {1'b0, gives, term[W+3:L]};
  wire [H:0] high_more = {1'b0, f_q[W+3:L]} - {1'b1, ~term[W+3:L]};
  wire into_high = high[H+1];
  wire around = gives ? take | high_more[H] : high[H] ^ passes;

  always @(posedge clk)
    if (clear) f_q <= {{(W+2){1'b0}}, 2'b11};
    else if (take | add) begin
      f_q[W+3:L] <= into_high ? (take ? loaded[W+3:L] : high_more[H-1:0]) : high[H-1:0];
      f_q[L-1:0] <= around ? (take ? loaded[L-1:0] : low_more[L-1:0]) : low[L-1:0];
    end

endmodule

`default_nettype wire
