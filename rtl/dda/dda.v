// Interpolator by the method of differential increments, a DDA: any curve of second order,
// A x^2 + B xy + C y^2 + D x + E y + F = 0, anticlockwise for A = C > 0. On each clock the rates
// x' = -(B x + 2 C y + E) and y' = 2 A x + B y + D go into the accumulators SX and SY of W bits; an
// overflow is a step of +1 on that axis, a borrow a step of -1. A step changes the rates by 2 A, B
// and 2 C, so nothing is multiplied. A line has A = B = C = 0; a circle about (0, 0) has
// 2 A = 2 C = 1, so that its rates are -y and x, the point that the source puts there.
//
// Inputs are sampled at the rising edge of clk; what they do, in order of precedence:
//   rst      clears every register. The steps of that clock are given all the same.
//   running  stop, or no steps left on both axes while free is 0: the machine stops, and nothing
//            else changes; no step is given on that clock.
//            Else, where normalise is 1 and neither rate is 2^(W-1) or more in size: both rates are
//            shifted left by one; no step. Two rates of 0 are shifted until a stop.
//            Else the rates are added to the accumulators, and steps are given. While free is 0 an
//            axis with no steps left gives none, its accumulator runs on, and a step takes one from
//            the steps left.
//            write, address, data and start change nothing.
//   idle     write: the register at `address` takes the lower bits of data.
//            start without stop: the machine runs from the next clock on, with what is written on
//            this clock, too. A stop does not keep a write from being taken.
//
//   address   0                                    1   2   3       4       5  6  7       8
//   register  sequential, normalise, free: bits    SX  SY  rate_x  rate_y  x  y  left_x  left_y
//             0, 1 and 2 of data
//   address   9    10  11   12 to 15
//   register  2 A  B   2 C  none: nothing changes
//
// sequential 0: both rates are those before the clock, as in the source's hardware. 1: SY gets its
// rate as the step of x on the same clock has left it, as in the source's flow chart, (8) to (10).
// Its FLAG, move and delay, (4) to (6), are the outputs x_up to y_down of a clock.
// Numbers of W + 1 bits are two's complement. Rates and codes wrap modulo 2^(W+1).
`default_nettype none

module dda #(
  // Bits of an accumulator, 2 to 32.
  parameter integer W = 16
) (
  input  wire         clk,
  input  wire         rst,

  // Preparation
  input  wire         write,
  input  wire [3:0]   address,
  input  wire [W:0]   data,

  // Work
  input  wire         start,
  input  wire         stop,
  output wire         busy,

  // Increments
  output wire         x_up,
  output wire         x_down,
  output wire         y_up,
  output wire         y_down,

  // Codes: the point before this clock's step
  output wire [W:0]   code_x,
  output wire [W:0]   code_y
);

  // Elaboration stops here, on a module that does not exist, for a width out of range.
  generate
    if (W < 2 || W > 32) begin : g_width_out_of_range
      dda_needs_2_le_W_le_32 error ();
    end
  endgenerate

  // ---- Registers --------------------------------------------------------------------------------
  reg         running_q, sequential_q, normalise_q, free_q;
  reg [W-1:0] sx_q, sy_q;
  reg [W:0]   rate_x_q, rate_y_q;    // P1, P2
  reg [W:0]   x_q, y_q;              // P3, P4
  reg [W-1:0] left_x_q, left_y_q;    // P5, P6
  reg [W:0]   two_a_q, b_q, two_c_q;

  // ---- What this clock is for -------------------------------------------------------------------
  wire none_left_x = ~|left_x_q;
  wire none_left_y = ~|left_y_q;
  wire over = stop | (~free_q & none_left_x & none_left_y);
  wire full_x, full_y;
  wire shift = normalise_q & ~full_x & ~full_y;
  wire step = running_q & ~over & ~shift;

  // ---- Accumulators -----------------------------------------------------------------------------
  wire [W-1:0] next_sx, next_sy;
  wire [W:0]   turned_x, turned_y;   // the rates after the step of x

  dda_axis #(.W(W)) axis_x (
    .s(sx_q),
    .rate(rate_x_q),
    .may_step(step & (free_q | ~none_left_x)),
    .next_s(next_sx),
    .up(x_up),
    .down(x_down)
  );

  dda_axis #(.W(W)) axis_y (
    .s(sy_q),
    .rate(sequential_q ? turned_y : rate_y_q),
    .may_step(step & (free_q | ~none_left_y)),
    .next_s(next_sy),
    .up(y_up),
    .down(y_down)
  );

  // ---- Rates: what each step adds to them -------------------------------------------------------
  wire [W:0] next_rate_x, next_rate_y;

  dda_change #(.W(W)) x_by_x (
    .rate(rate_x_q), .by(b_q), .add(x_down), .subtract(x_up), .result(turned_x)
  );
  dda_change #(.W(W)) x_by_y (
    .rate(turned_x), .by(two_c_q), .add(y_down), .subtract(y_up), .result(next_rate_x)
  );
  dda_change #(.W(W)) y_by_x (
    .rate(rate_y_q), .by(two_a_q), .add(x_up), .subtract(x_down), .result(turned_y)
  );
  dda_change #(.W(W)) y_by_y (
    .rate(turned_y), .by(b_q), .add(y_up), .subtract(y_down), .result(next_rate_y)
  );

  dda_full #(.W(W)) size_x (.rate(rate_x_q), .full(full_x));
  dda_full #(.W(W)) size_y (.rate(rate_y_q), .full(full_y));

  // ---- The clock's edge -------------------------------------------------------------------------
  always @(posedge clk)
    if (rst) running_q <= 1'b0;
    else running_q <= running_q ? ~over : start & ~stop;

  wire take = write & ~running_q;

  always @(posedge clk)
    if (rst) {free_q, normalise_q, sequential_q} <= 3'd0;
    else if (take & address == 4'd0) {free_q, normalise_q, sequential_q} <= data[2:0];

  always @(posedge clk)
    if (rst) begin
      sx_q <= {W{1'b0}};
      sy_q <= {W{1'b0}};
    end else if (step) begin
      sx_q <= next_sx;
      sy_q <= next_sy;
    end else if (take) begin
      if (address == 4'd1) sx_q <= data[W-1:0];
      if (address == 4'd2) sy_q <= data[W-1:0];
    end

  always @(posedge clk)
    if (rst) begin
      rate_x_q <= {W+1{1'b0}};
      rate_y_q <= {W+1{1'b0}};
    end else if (step) begin
      rate_x_q <= next_rate_x;
      rate_y_q <= next_rate_y;
    end else if (running_q & ~over) begin
      rate_x_q <= {rate_x_q[W-1:0], 1'b0};
      rate_y_q <= {rate_y_q[W-1:0], 1'b0};
    end else if (take) begin
      if (address == 4'd3) rate_x_q <= data;
      if (address == 4'd4) rate_y_q <= data;
    end

  localparam [W:0] ONE = {{W{1'b0}}, 1'b1};

  always @(posedge clk)
    if (rst) begin
      x_q <= {W+1{1'b0}};
      y_q <= {W+1{1'b0}};
    end else if (take) begin
      if (address == 4'd5) x_q <= data;
      if (address == 4'd6) y_q <= data;
    end else begin
      if (x_up | x_down) x_q <= x_down ? x_q - ONE : x_q + ONE;
      if (y_up | y_down) y_q <= y_down ? y_q - ONE : y_q + ONE;
    end

  always @(posedge clk)
    if (rst) begin
      left_x_q <= {W{1'b0}};
      left_y_q <= {W{1'b0}};
    end else if (take) begin
      if (address == 4'd7) left_x_q <= data[W-1:0];
      if (address == 4'd8) left_y_q <= data[W-1:0];
    end else if (~free_q) begin
      if (x_up | x_down) left_x_q <= left_x_q - ONE[W-1:0];
      if (y_up | y_down) left_y_q <= left_y_q - ONE[W-1:0];
    end

  always @(posedge clk)
    if (rst) begin
      two_a_q <= {W+1{1'b0}};
      b_q <= {W+1{1'b0}};
      two_c_q <= {W+1{1'b0}};
    end else if (take) begin
      if (address == 4'd9) two_a_q <= data;
      if (address == 4'd10) b_q <= data;
      if (address == 4'd11) two_c_q <= data;
    end

  assign busy = running_q;
  assign code_x = x_q;
  assign code_y = y_q;

endmodule

`default_nettype wire
