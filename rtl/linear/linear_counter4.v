// Counter 4 (35 in the source's Fig. 4): the words still to form. One bit more than BP's N high
// bits, for a line can have 2^N words.
`default_nettype none

module linear_counter4 #(
  parameter integer N = 13
) (
  input  wire         clk,
  input  wire         clear,

  // At most one of load, up and down is 1.
  input  wire         load,       // (15)
  input  wire [N-1:0] words,      // the N high bits of BP
  input  wire         up,         // (8) one more word, for the remainder
  input  wire         down,       // (21)

  output reg  [N:0]   counter4_q
);

  // +1 or -1. `down` comes late, from a zero test of this counter, so it only enables.
  wire [N:0] step = {{N{~up}}, 1'b1};

  always @(posedge clk)
    if (clear) counter4_q <= {(N + 1){1'b0}};
    else if (load) counter4_q <= {1'b0, words};
    else if (up | down) counter4_q <= counter4_q + step;

endmodule

`default_nettype wire
