// Up/down counter (7), ones' complement: Y in sector 1 (up), X - 1 in sector 2 (down). Each clock
// of a run is a pulse from (17): steps of all kinds count, and so does the correction, for variant
// -2 twice.
`default_nettype none

module circular_counter7 #(
  parameter integer W = 16
) (
  input  wire         clk,
  input  wire         clear,
  input  wire         take,
  input  wire [W:0]   ct7,        // (30)

  // Counting, while CT7 is not negative
  input  wire         count,      // (17)
  input  wire         down,       // T16, set already by the correction
  input  wire         two,        // (19) variant -2 takes 1 twice

  output reg  [W:0]   ct7_q,
  output wire [W-1:0] ct7_pairs,  // the digits above the lowest, 1 up or down
  output wire         ct7_zero
);

  // Zero has two codes, so passing below it takes one more: these are the two lowest digits then.
  assign ct7_zero = ~|ct7_q[W-1:0];
  wire zero_or_one = ~|ct7_q[W:1];
  wire lowest = ~ct7_q[0] & ~(down & ct7_zero);
  wire [1:0] two_lowest = zero_or_one ? {ct7_q[0], ~ct7_q[0]} : {~ct7_q[1], ct7_q[0]};

  assign ct7_pairs = ct7_q[W:1] + {{(W-1){down}}, 1'b1};

  always @(posedge clk)
    if (clear) ct7_q <= {W+1{1'b0}};
    else if (take) ct7_q <= &ct7 ? {W+1{1'b0}} : ct7;
    else if (count) begin
      if (two | (ct7_q[0] ^ down)) ct7_q[W:1] <= ct7_pairs;
      if (two) ct7_q[1:0] <= two_lowest;
      else ct7_q[0] <= lowest;
    end

endmodule

`default_nettype wire
