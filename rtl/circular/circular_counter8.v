// Down counter 8, ones' complement: X - Y - 1 in sector 1, X - Y in sector 2.
`default_nettype none

module circular_counter8 #(
    parameter W = 16
) (
    input  wire       clk,
    input  wire       clear,
    input  wire       take,
    input  wire [W:0] ct8,       // 31
    // Counting, at most one of them
    input  wire       down,      // 20  a straight step
    input  wire       down_two,  // 9   a diagonal step: the input of the second digit
    input  wire       variant1,  // 22  -1 becomes  0
    input  wire       variant2,  // 23  -2 becomes -1
    output reg  [W:0] ct8_q,
    output wire [W:0] ct8_step   //     after this clock's step
);

  localparam [W:0] ONE = {{W{1'b0}}, 1'b1};
  localparam [W:0] TWO = {{(W-1){1'b0}}, 2'b10};

  // Zero has two codes, so passing below it takes one more.
  wire zero        = ~|ct8_q;
  wire zero_or_one = ~|ct8_q[W:1];

  assign ct8_step = down_two ? ct8_q - TWO - {{W{1'b0}}, zero_or_one}
                             : ct8_q - ONE - {{W{1'b0}}, zero};

  always @(posedge clk)
    if (clear)                ct8_q <= {W+1{1'b0}};
    else if (take)            ct8_q <= &ct8 ? {W+1{1'b0}} : ct8;
    else if (down | down_two) ct8_q <= ct8_step;
    else if (variant1)        ct8_q <= {W+1{1'b0}};
    else if (variant2)        ct8_q <= {{W{1'b1}}, 1'b0};

endmodule

`default_nettype wire
