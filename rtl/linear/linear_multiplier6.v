// Binary rate multiplier (6): counts the words formed, modulo 2^N, and gives for tick k, the next
// one, the bit of the code at position 2^(M - N) of the word, which is bit j of the code (j = 1 the
// high one) where k = 2^(j - 1) * odd, and 0 for k = 2^N.
`default_nettype none

module linear_multiplier6 #(
  parameter integer N = 13
) (
  input  wire         clk,
  input  wire         clear,
  input  wire         count,      // (21)
  input  wire [N-1:0] code,       // register 3
  output wire         rate_bit    // to trigger 10
);

  localparam [N-1:0] ZERO = 0;
  localparam [N-1:0] ONE = 1;

  reg [N-1:0] ticks_q;

  // The lowest 1 of k is the one bit that the count turns from 0 to 1; k = 2^N has none.
  wire [N-1:0] next_tick = ticks_q + ONE;
  wire [N-1:0] rising = next_tick & ~ticks_q;
  wire [N-1:0] chosen;

  assign rate_bit = |chosen;

  genvar j;
  generate
    for (j = 1; j <= N; j = j + 1) begin : g_bit
      assign chosen[j-1] = rising[j-1] & code[N-j];
    end
  endgenerate

  always @(posedge clk)
    if (clear) ticks_q <= ZERO;
    else if (count) ticks_q <= next_tick;

endmodule

`default_nettype wire
