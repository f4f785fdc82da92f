// Commutator 6: the word added to F, in ones' complement, from one of three channels (gates 37).
//
//   channel | code                 | value
//   1       | {CT8 - 2, not T16}   | 2(X' - Y') - 1
//   2       | {CT7 - 1, 1}         | 2X' - 1;  in the correction 2X + 1 (variant -2)
//           | {CT7, 0}             | in the correction 2X (variant -1)
//   3       | {not (CT7 + 1), 0}   | -(2Y' + 1)
//
// Their digits above the lowest come from the counters' two chains, or are CT7's own.
`default_nettype none

module circular_commutator #(
    parameter W = 16
) (
    input  wire         t16_q,            // 16
    input  wire [W:0]   ct7_q,            // 7
    input  wire [W-1:0] ct7_pairs,
    input  wire         ct7_zero,
    input  wire         ct8_odd,          // 8   by its lowest digit, 1
    input  wire [W-1:0] ct8_pairs,
    input  wire         ct8_zero_or_one,
    input  wire         ct8_falls,
    // Channel selects; with none of them channel 2 takes CT7 as it stands (variant -1)
    input  wire         channel1,         // 12
    input  wire         channel2,         // 15
    input  wire         channel3,         // 14
    output wire [W+1:0] addend,
    output wire         negative          //     its sign
);

  wire [W-1:0] still = channel1 ? ct8_pairs : ct7_q[W:1];
  wire         moved = (channel3 & ct7_q[0]) | (channel2 & ~ct7_q[0]);
  wire [W-1:0] pairs = (moved ? ct7_pairs : still) ^ {W{channel3}};

  // CT7 - 1 and CT7 + 1 have the other lowest digit, the latter inverted again.
  wire lowest = channel1 ? ct8_odd : ct7_q[0] ^ channel2;

  // Zero has two codes, so passing below it takes one more. In sector 1 the step that does so leaves
  // it. Its own update is taken as the source does for variant -2: T16 set and 1 added to CT8 first,
  // so that -1 and -2 give -1 and -3. (The -0 that -1 becomes is the all-ones code here.) In channel
  // 2 it is 2(-1) + 1, which is -1.
  wire below = channel1 & t16_q & ct8_zero_or_one;
  wire last  = (channel1 & ~t16_q & ~ct8_zero_or_one) | (channel2 & ~ct7_zero);

  assign addend = {pairs[W-1:1], pairs[0] & ~(below & ~ct8_odd), lowest ^ below, last};

  // The sign from the counters themselves, before any chain has run.
  assign negative = channel1 ? ct8_falls
                  : channel3 ? ~&ct7_q[W-1:0]
                             : channel2 & ct7_zero;

endmodule

`default_nettype wire
