// Linear interpolator, SU 1631518: a straight line of BP steps on the major axis, WORD of them a
// clock. The numbers in parentheses are the source's blocks and pins. WORD = 2^(M - N), and bit
// WORD - 1 of a word is its position 1, the leftmost as the source prints it.
//
// What a clock edge does, the first case that holds:
//   reset (26)          every register to 0.
//   initial_set_n = 0   (17) forgets the line: everything but the code in 3 and 9 to 0; no write
//                       and no start is taken. (The source keeps 4 and 5 as well; a code written
//                       next would then count the remainder a second time.)
//   busy, 4 not 0       the count pulse (21): 4 counts down, 6 counts up modulo 2^N, 10 takes the
//                       bit of 6, and 30 is set: a word is formed, strobed on the next clock.
//   busy, 4 = 0         the end: the same. A code written without a new BP draws a line of length
//                       0. Writes and starts change nothing while busy.
//   write_bp            (15) 4 takes the N high bits of data, 5 the low ones, 32 to 0: a code
//                       belongs to a line and is written after it. A write_uk or a start on the
//                       same clock is lost.
//   write_uk            (16) 3 takes the N low bits of data, 9 the word of ROM 2 at the high ones,
//                       32 is set; where 32 was 0, 4 counts up if 5 is not 0 (modulo 2^(N + 1)):
//                       a code written twice counts the remainder once. A start is lost.
//   start               (18) where 32 is 1, sets 31: the machine is busy. Where 32 is 0, nothing.
// What no case names keeps its value.
//
// After a start on clock t, busy (22) is 1 from t + 1 to the last strobe; strobe (23) is 1 on the
// ceil(BP / WORD) clocks from t + 2 on. BP = 0: busy for one clock, no strobe. The words are 0
// while strobe is 0.
//
// Where this differs from the source: counter 4 has N + 1 bits, for it must hold 2^N; ROM 11 is
// deselected only if there is a remainder, lest the last word of a line of whole words is lost;
// the gates 13 are AND elements, as the source's own Table 3 has it.
`default_nettype none

module linear #(
  // Bits of BP and UK, and those of them that count words: 1 <= N < M <= 32, M - N <= 6.
  parameter integer M = 16,
  parameter integer N = 13
) (
  input  wire                      clk,            // stands in for the generator (27)
  input  wire                      initial_set_n,  // (17)
  input  wire                      reset,          // (26)

  // Preparation
  input  wire [M-1:0]              data,           // (14) BP or UK; bit M - 1 of UK is a_1
  input  wire                      write_bp,       // (15)
  input  wire                      write_uk,       // (16)

  // Work
  input  wire                      start,          // (18)
  output wire                      busy,           // (22)
  output wire                      strobe,         // (23)
  output wire [(1 << (M - N))-1:0] minor,          // (24)
  output wire [(1 << (M - N))-1:0] major           // (25)
);

  localparam integer GAMMA = M - N;
  localparam integer WORD = 1 << GAMMA;

  // Elaboration stops here, on a module that does not exist, for parameters out of range.
  generate
    if (N < 1 || N >= M || M > 32 || M - N > 6) begin : g_parameters_out_of_range
      linear_needs_1_le_N_lt_M_le_32_and_M_minus_N_le_6 error ();
    end
  endgenerate

  // ---- Control unit (1) -------------------------------------------------------------------------
  wire trigger30_q;
  wire trigger31_q;
  wire trigger32_q;
  wire carry;           // (19) counter 4 is 0
  wire clear_work;      // (20)
  wire count;           // (21)
  wire load_bp;
  wire load_uk;

  linear_control control (
    .clk(clk),
    .initial_set_n(initial_set_n),
    .reset(reset),
    .write_bp(write_bp),
    .write_uk(write_uk),
    .start(start),
    .carry(carry),
    .clear_work(clear_work),
    .count(count),
    .load_bp(load_bp),
    .load_uk(load_uk),
    .trigger30_q(trigger30_q),
    .trigger31_q(trigger31_q),
    .trigger32_q(trigger32_q)
  );

  assign busy = trigger31_q;
  assign strobe = trigger30_q;

  // ---- Register of the remainder (5), non-zero detector (7) -------------------------------------
  reg [GAMMA-1:0] register5_q;
  wire remainder = |register5_q;

  always @(posedge clk)
    if (clear_work) register5_q <= {GAMMA{1'b0}};
    else if (load_bp) register5_q <= data[GAMMA-1:0];

  // ---- Counter of the words left (4), its OR element (34), AND (8) ------------------------------
  wire [N:0] counter4_q;
  wire add_remainder = load_uk & ~trigger32_q & remainder;

  linear_counter4 #(.N(N)) counter4 (
    .clk(clk),
    .clear(clear_work),
    .load(load_bp),
    .words(data[M-1:GAMMA]),
    .up(add_remainder),
    .down(count),
    .counter4_q(counter4_q)
  );

  assign carry = ~|counter4_q;

  // ---- Register of the low bits of UK (3), multiplier (6), trigger of its bit (10) --------------
  reg [N-1:0] register3_q;
  reg trigger10_q;
  wire rate_bit;

  linear_multiplier6 #(.N(N)) multiplier6 (
    .clk(clk),
    .clear(clear_work),
    .count(count),
    .code(register3_q),
    .rate_bit(rate_bit)
  );

  always @(posedge clk)
    if (reset) register3_q <= {N{1'b0}};
    else if (load_uk) register3_q <= data[N-1:0];

  always @(posedge clk)
    if (clear_work) trigger10_q <= 1'b0;
    else if (count) trigger10_q <= rate_bit;

  // ---- ROM of the control code (2), register of its word (9) ------------------------------------
  wire [WORD-2:0] rom2_word;
  reg [WORD-2:0] register9_q;

  linear_rom2 #(.GAMMA(GAMMA)) rom2 (
    .address(data[M-1:N]),
    .word(rom2_word)
  );

  always @(posedge clk)
    if (reset) register9_q <= {(WORD - 1){1'b0}};
    else if (load_uk) register9_q <= rom2_word;

  // ---- ROM of the major axis (11) ---------------------------------------------------------------
  wire [WORD-1:0] rom11_word;

  linear_rom11 #(.GAMMA(GAMMA)) rom11 (
    .chip_select(~(carry & remainder)),
    .address(register5_q),
    .word(rom11_word)
  );

  // ---- Gates (12) of AND elements (13) ----------------------------------------------------------
  assign major = rom11_word & {WORD{strobe}};
  assign minor = {register9_q, trigger10_q} & major;

endmodule

`default_nettype wire
