// Down counter (8), ones' complement: X - Y - 1 in sector 1, X - Y in sector 2. A straight step, a
// pulse from (20), takes 1; a diagonal one, from (9), takes 2; the correction, from (21), adds 1.
`default_nettype none

module circular_counter8 #(
  parameter integer W = 16
) (
  input  wire         clk,
  input  wire         clear,
  input  wire         take,
  input  wire [W:0]   ct8,              // (31)

  // Counting: a step, or the correction
  input  wire         count,
  input  wire         two,              // (9) the input of the second digit
  input  wire         variant1,         // (22) -1 becomes  0
  input  wire         variant2,         // (23) -2 becomes -1

  output reg  [W:0]   ct8_q,
  output wire [W-1:0] ct8_pairs,        // the digits above the lowest, 1 down
  output wire         ct8_zero_or_one,
  output wire         ct8_falls         // CT8 - 2 is negative
);

  // Zero has two codes, so passing below it takes one more: these are the two lowest digits then.
  assign ct8_zero_or_one = ~|ct8_q[W:1];
  wire lowest = ~ct8_q[0] & ~ct8_zero_or_one;
  wire [1:0] two_lowest = ct8_zero_or_one ? {ct8_q[0], ~ct8_q[0]} : {~ct8_q[1], ct8_q[0]};

  assign ct8_pairs = ct8_q[W:1] - {{(W-1){1'b0}}, 1'b1};
  assign ct8_falls = ct8_q[W] ^ ~|ct8_q[W-1:1];

  always @(posedge clk)
    if (clear) ct8_q <= {W+1{1'b0}};
    else if (take) ct8_q <= &ct8 ? {W+1{1'b0}} : ct8;
    else if (count) begin
      if (variant1) ct8_q <= {W+1{1'b0}};
      else if (variant2) ct8_q <= {{W{1'b1}}, 1'b0};
      else begin
        if (two | ~ct8_q[0]) ct8_q[W:1] <= ct8_pairs;
        if (two) ct8_q[1:0] <= two_lowest;
        else ct8_q[0] <= lowest;
      end
    end

endmodule

`default_nettype wire
