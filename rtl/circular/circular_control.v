// Mode flip-flop (4), sector flip-flop (16), the step gates (2), (3), (10), (11) and the
// recognition of the sector change (22), (23), with the OR gates (9), (18), (24) behind them.
//
// One of straight_y, straight_x, diagonal, variant1 and variant2 is 1 on every clock. While the
// machine does not run it means nothing; on the last clock clear wins over it.
`default_nettype none

module circular_control (
  input  wire clk,
  input  wire rst,
  input  wire load,
  input  wire start,         // (33)
  input  wire stop,          // (32)
  input  wire sector2,       // (34)

  // State of the blocks
  input  wire f_negative,    // sign of accumulator (1)
  input  wire ct7_negative,  // CT7 has passed below zero: X = 0
  input  wire ct8_negative,
  input  wire ct8_lowest,    // its lowest digit
  output reg  t4_q,          // (4)
  output reg  t16_q,         // (16)

  // What happens on this clock
  output wire clear,
  output wire take,          // the start values
  output wire step,          // a step is given out
  output wire down,          // counter 7 counts down: sector 2 or the correction
  output wire straight_y,    // (3)
  output wire straight_x,    // (11)
  output wire diagonal,      // (9)
  output wire variant1,      // (22)
  output wire variant2       // (23)
);

  wire finish = t4_q & ct7_negative;

  // (24), (25): no step while the correction runs.
  wire correct = ~t16_q & ct8_negative;
  assign step = t4_q & ~ct7_negative & ~stop & ~correct;
  assign down = t16_q | ct8_negative;

  assign clear = rst | stop | finish;
  assign take = load & ~t4_q;

  wire   sector1_diagonal = ~t16_q & ~ct8_negative &  f_negative;  // (2)
  assign straight_y       = ~t16_q & ~ct8_negative & ~f_negative;  // (3)
  wire   sector2_diagonal =  t16_q                 & ~f_negative;  // (10)
  assign straight_x       =  t16_q                 &  f_negative;  // (11)
  assign diagonal = sector1_diagonal | sector2_diagonal;           // (9)

  // In sector 1 a negative CT8 is -1, code 1..110, or -2, code 1..101, and its lowest digit tells
  // which. (A value below that can only have been loaded; it is taken for the one of the two that
  // has its parity.)
  assign variant1 = correct & ~ct8_lowest;  // (22)
  assign variant2 = correct &  ct8_lowest;  // (23)

  always @(posedge clk)
    if (clear) begin
      t4_q <= 1'b0;
      t16_q <= 1'b0;
    end else if (t4_q) begin
      t16_q <= t16_q | correct;  // (18)
    end else begin
      t4_q <= start;
      t16_q <= t16_q | sector2;  // (18)
    end

endmodule

`default_nettype wire
