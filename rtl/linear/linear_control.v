// Control unit (1) of the linear interpolator: what each clock is for. The header of linear.v says
// which input wins. The machine is busy while trigger 31 is 1; clk stands in for the generator (27)
// and its AND elements 28 and 29.
`default_nettype none

module linear_control (
  input  wire clk,
  input  wire initial_set_n,  // (17)
  input  wire reset,          // (26)

  // Requests
  input  wire write_bp,       // (15)
  input  wire write_uk,       // (16)
  input  wire start,          // (18)
  input  wire carry,          // (19) counter 4 is 0

  // Orders for this clock's edge; clear_work wins over the others in the registers
  output wire clear_work,     // (20) all but the code to 0: reset, initial set or the line's end
  output wire count,          // (21)
  output wire load_bp,
  output wire load_uk,

  // State
  output reg  trigger30_q,    // a word is formed: the strobe
  output reg  trigger31_q,    // interpolating
  output reg  trigger32_q     // a code is loaded
);

  wire work = initial_set_n & trigger31_q;
  wire idle = initial_set_n & ~trigger31_q;

  assign count = work & ~carry;
  assign load_bp = idle & write_bp;
  assign load_uk = idle & write_uk & ~write_bp;

  // AND 33: with no code loaded a start does nothing.
  wire begin_work = idle & start & trigger32_q & ~write_bp & ~write_uk;

  assign clear_work = reset | ~initial_set_n | (trigger31_q & carry);

  always @(posedge clk)
    if (clear_work) begin
      trigger30_q <= 1'b0;
      trigger31_q <= 1'b0;
      trigger32_q <= 1'b0;
    end else begin
      if (count) trigger30_q <= 1'b1;
      if (begin_work) trigger31_q <= 1'b1;
      if (load_bp) trigger32_q <= 1'b0;
      else if (load_uk) trigger32_q <= 1'b1;
    end

endmodule

`default_nettype wire
