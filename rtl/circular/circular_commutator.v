// Commutator 6: the word added to F, in ones' complement, from one of three channels (gates 37).
//
//   channel | code                | value
//   1       | {CT8, not T16}      | 2(X' - Y') - 1
//   2       | {CT7, T16}          | 2X' - 1;  in the correction 2X (variant -1), 2X + 1 (variant -2)
//   3       | {not CT7, 0}        | -(2Y' + 1)
`default_nettype none

module circular_commutator #(
    parameter W = 16
) (
    input  wire         t16_q,          // 16
    input  wire [W:0]   ct7_q,          // 7
    input  wire [W:0]   ct7_up,
    input  wire [W:0]   ct7_down,
    input  wire [W:0]   ct8_step,       // 8
    // Channel selects, at most one of them
    input  wire         channel1,       // 12
    input  wire         channel2,       // 15  with CT7 - 1
    input  wire         channel2_even,  // 15  with CT7 as it stands and T16 still 0
    input  wire         channel3,       // 14
    output wire [W+1:0] addend
);

  // The step that leaves sector 1 makes CT8 negative. Its own update is taken as the source does
  // for variant -2: T16 set and 1 added to CT8 first, so that -1 and -2 give -1 and -3. (The -0
  // that -1 becomes is the all-ones code here.)
  wire         leaving = ~t16_q & ct8_step[W];
  wire [W+1:0] word1   = leaving ? {{W{1'b1}}, ~ct8_step[0], 1'b0} : {ct8_step, ~t16_q};

  // Below zero the code doubled would be one too low: 2(-1) + 1 is -1.
  wire [W+1:0] word2   = ct7_down[W] ? {{(W+1){1'b1}}, 1'b0} : {ct7_down, 1'b1};

  assign addend = ({W+2{channel1}} & word1)
                | ({W+2{channel2}} & word2)
                | ({W+2{channel2_even}} & {ct7_q, 1'b0})
                | ({W+2{channel3}} & {~ct7_up, 1'b0});

endmodule

`default_nettype wire
