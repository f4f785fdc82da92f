// Up/down counter 7, ones' complement: Y in sector 1 (up), X - 1 in sector 2 (down).
`default_nettype none

module circular_counter7 #(
    parameter W = 16
) (
    input  wire       clk,
    input  wire       clear,
    input  wire       take,
    input  wire [W:0] ct7,       // 30
    // Counting, at most one of them; never while CT7 is negative
    input  wire       up,
    input  wire       down,      // 17
    input  wire       down_two,  //     variant -2 takes 1 twice
    output reg  [W:0] ct7_q,
    output wire [W:0] ct7_up,    //     CT7 + 1
    output wire [W:0] ct7_down   //     CT7 - 1
);

  localparam [W:0] ONE = {{W{1'b0}}, 1'b1};
  localparam [W:0] TWO = {{(W-1){1'b0}}, 2'b10};

  // Zero has two codes, so passing below it takes one more.
  wire zero         = ~|ct7_q;
  wire zero_or_one  = ~|ct7_q[W:1];

  assign ct7_up   = ct7_q + ONE;
  assign ct7_down = ct7_q - ONE - {{W{1'b0}}, zero};

  always @(posedge clk)
    if (clear)         ct7_q <= {W+1{1'b0}};
    else if (take)     ct7_q <= &ct7 ? {W+1{1'b0}} : ct7;
    else if (up)       ct7_q <= ct7_up;
    else if (down)     ct7_q <= ct7_down;
    else if (down_two) ct7_q <= ct7_q - TWO - {{W{1'b0}}, zero_or_one};

endmodule

`default_nettype wire
