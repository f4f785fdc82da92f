// Commutator (6): the word added to F, in ones' complement, from one of three channels.
//
//   channel | code                 | value
//   1       | {CT8 - 2, not T16}   | 2(X' - Y') - 1
//   2       | {CT7 - 1, 1}         | 2X' - 1;  in the correction 2X + 1 (variant -2)
//           | {CT7, 0}             | in the correction 2X (variant -1)
//   3       | {not (CT7 + 1), 0}   | -(2Y' + 1)
//
// The source counts first and, a delay (12, 13, 14) later, passes on what the counters then hold.
// Here both are one clock, so a channel has the count ahead of its edge. It does not take it from
// the counter's next word: what that chooses between, behind a chain, would stand before the
// accumulator's carry, on the longest path. The digits above the lowest come from the counters' two
// chains, or are CT7's own; the digits below come from the registers by a few gates.
//
//   the source's wire                  | here
//   channel 1  CT8, one place up       | {ct8_pairs, ct8_lowest}, put right by `below`
//              lowest digit: not T16   | `last`: channel1 & ~t16_q
//   channel 2  CT7, one place up       | {ct7_pairs or ct7_q[W:1], ct7_q[0] ^ channel2_down}
//              lowest digit: T16       | `last`: channel2_down, with which T16 is 1 or set first
//   channel 3  not CT7, one place up   | the same with CT7 + 1, inverted by channel3
//              lowest digit: not T4    | `last`: no term, for T4 is 1 whenever F is added to
//   A1 from (12), A3 from (14)         | channel1, channel3
//   A2 from (15)                       | neither; channel2_down where CT7 is counted first
//   (37), a gate for each digit        | still, moved and pairs; lowest; last
`default_nettype none

module circular_commutator #(
  parameter integer W = 16
) (
  input  wire         t16_q,            // (16)
  input  wire [W:0]   ct7_q,            // (7)
  input  wire [W-1:0] ct7_pairs,
  input  wire         ct7_zero,
  input  wire         ct8_lowest,       // (8) its lowest digit
  input  wire [W-1:0] ct8_pairs,
  input  wire         ct8_zero_or_one,
  input  wire         ct8_falls,

  // At most one of these is 1; with none channel 2 takes CT7 as it stands, for variant -1.
  input  wire         channel1,         // (12)
  input  wire         channel2_down,    // (15) channel 2, behind a count down of CT7
  input  wire         channel3,         // (14)

  output wire [W+1:0] addend,
  output wire         negative          // its sign
);

  wire [W-1:0] still = channel1 ? ct8_pairs : ct7_q[W:1];
  wire moved = (channel3 & ct7_q[0]) | (channel2_down & ~ct7_q[0]);
  wire [W-1:0] pairs = (moved ? ct7_pairs : still) ^ {W{channel3}};

  // CT7 - 1 and CT7 + 1 have the other lowest digit, the latter inverted again.
  wire lowest = channel1 ? ct8_lowest : ct7_q[0] ^ channel2_down;

  // Zero has two codes, so passing below it takes one more. In sector 1 the step that does so
  // leaves it. Its own update is taken as the source does for variant -2: T16 set and 1 added to
  // CT8 first, so that -1 and -2 give -1 and -3. (The -0 that -1 becomes is the all-ones code
  // here.) In channel 2 it is 2(-1) + 1, which is -1.
  wire below = channel1 & t16_q & ct8_zero_or_one;
  wire last = (channel1 & ~t16_q & ~ct8_zero_or_one) | (channel2_down & ~ct7_zero);

  assign addend = {pairs[W-1:1], pairs[0] & ~(below & ~ct8_lowest), lowest ^ below, last};

  // The sign from the counters themselves, before any chain has run.
  assign negative = channel1 ? ct8_falls
                  : channel3 ? ~&ct7_q[W-1:0]
                             : channel2_down & ct7_zero;

endmodule

`default_nettype wire
