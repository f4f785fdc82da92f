// Accumulator 1: the evaluation function F in ones' complement with two fraction bits, added to
// with end-around carry. Its sign decides the step.
//
// F keeps the fraction .75 (code 11, or 10 where F is negative), so a load is never zero; and a sum
// with end-around carry is +0 only where both terms are. The code of +0 therefore never occurs. A
// sum that wraps may be -0, all ones, and counts as negative.
`default_nettype none

module circular_accumulator #(
    parameter W = 16
) (
    input  wire         clk,
    input  wire         clear,
    input  wire         take,
    input  wire [W+1:0] f,       // 29  floor(F), two's complement
    input  wire [W+1:0] addend,  //     whole steps, ones' complement; +0 leaves F as it is
    output reg  [W+3:0] f_q
);

  // The fraction bits of a whole number repeat its sign.
  wire [W+3:0] term = {addend, {2{addend[W+1]}}};
  wire [W+4:0] sum  = {1'b0, f_q} + {1'b0, term};

  always @(posedge clk)
    if (clear)     f_q <= {{(W+2){1'b0}}, 2'b11};
    else if (take) f_q <= {f, 1'b1, ~f[W+1]};
    else           f_q <= sum[W+3:0] + {{(W+3){1'b0}}, sum[W+4]};

endmodule

`default_nettype wire
