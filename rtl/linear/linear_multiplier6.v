// Binary rate multiplier (6), the logic around its counter: for tick k = ticks + 1 the bit of the
// code at position 2^(M - N) of the word, which is bit j of the code (j = 1 the high one) where
// k = 2^(j - 1) * odd, and 0 for k = 2^N. The counter is a register of linear.v: nothing but this
// reads it, and a register is to be a net of the top module that something reads.
`default_nettype none

module linear_multiplier6 #(
  parameter integer N = 13
) (
  input  wire [N-1:0] code,       // register 3
  input  wire [N-1:0] ticks,      // the counter: words formed so far, modulo 2^N

  output wire [N-1:0] next_tick,  // k modulo 2^N
  output wire         rate_bit    // to trigger 10
);

  localparam [N-1:0] ONE = 1;

  // The lowest 1 of k is the one bit that the count turns from 0 to 1; k = 2^N has none.
  wire [N-1:0] rising = next_tick & ~ticks;
  wire [N-1:0] chosen;

  assign next_tick = ticks + ONE;
  assign rate_bit = |chosen;

  genvar j;
  generate
    for (j = 1; j <= N; j = j + 1) begin : g_bit
      assign chosen[j-1] = rising[j-1] & code[N-j];
    end
  endgenerate

endmodule

`default_nettype wire
