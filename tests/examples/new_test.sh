#!/usr/bin/env bash
# new_test.sh PROGRAM SOURCES
#
# `cosim new` reads ports, parameters and registers out of RTL, with --stream the streams among its
# ports, and refuses in one line what a design cannot have. SOURCES: the project's folder.
# Status: 0 so, 1 not, 77 where yosys is not installed.
set -euo pipefail

command -v yosys > /dev/null || { echo "skipped: no yosys" && exit 77; }
program=$1 sources=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# A register below the top, one that a port is wired to, a width that follows a parameter, one that
# does not, a reset that is active low, a clock by another name.
cat > pair.v << 'RTL'
module pair #(parameter WIDTH = 6) (
    input wire ck, input wire resetn, input wire [WIDTH-1:0] d, output reg [WIDTH:0] sum,
    output wire [2:0] low);
  reg [WIDTH-1:0] last;
  part one(.ck(ck), .d(d[2:0]), .q(low));
  always @(posedge ck) begin
    last <= resetn ? d : {WIDTH{1'b0}};
    sum <= resetn ? d + last : {WIDTH+1{1'b0}};
  end
endmodule
RTL
cat > part.v << 'RTL'
module part(input wire ck, input wire [2:0] d, output wire [2:0] q);
  reg [2:0] kept;
  assign q = kept;
  always @(posedge ck) kept <= d;
endmodule
RTL
"$program" new pair pair.v part.v > said
diff - said << 'SAID'
pair/: 2 inputs, 2 outputs, 3 registers; README.md has its two commands
pair/pair.h: next() is to be written
SAID
diff - <(sed -n '/^#define\|^  FIELD\|^COSIM/p; /rest()\|clear()/p' pair/pair.h) << 'TABLES'
#define PAIR_INPUTS(FIELD) \
  FIELD(resetn, 1, flag, "", "") \
  FIELD(d, p.WIDTH, bits, "", "")
#define PAIR_OUTPUTS(FIELD) \
  FIELD(sum, p.WIDTH + 1, bits, "", "") \
  FIELD(low, 3, bits, "", "")
#define PAIR_STATE(FIELD) \
  FIELD(last, p.WIDTH, bits, "", "") \
  FIELD(one_kept, 3, bits.at("one.kept").unreset(), "", "") \
  FIELD(sum, p.WIDTH + 1, bits, "", "")
COSIM_RECORDS(PAIR, Params);
  static constexpr Inputs<Word> rest() { return {.resetn = 1}; }
  static constexpr Inputs<Word> clear() { return {.resetn = 0}; }
TABLES
grep -qx 'cosim_add_design(pair SOURCES pair.v part.v CLOCK ck MODEL pair.h SHAPES "WIDTH=6")' \
  pair/CMakeLists.txt

# The same with a model on machine integers alone: nothing but its step and the call differ.
"$program" new plain pair.v part.v --plain > said
diff <(sed 's/pair/plain/g; s/PAIR/PLAIN/g' pair/pair.h) plain/plain.h > changed || true
diff - <(grep '^>' changed) << 'PLAIN'
> inline Step<Word> next([[maybe_unused]] const Params& p, const State<Word>& s,
>                        [[maybe_unused]] const Inputs<Word>& in) {
>   Step<Word> step{s, {}};
PLAIN
grep -q '^cosim_add_design(.* UNPROVED)$' plain/CMakeLists.txt

# Two clocks, each with a reset of its own, at once and at the clock; and one that falls. The model compiles.
cat > two.v << 'RTL'
module two(input wire w_clk, w_rst_n, d, input wire a_clk, a_rst, output reg q, output reg [1:0] n);
  reg held;
  always @(posedge w_clk or negedge w_rst_n) if (!w_rst_n) held <= 1; else held <= d;
  always @(posedge a_clk) begin
    if (a_rst) n <= 0; else n <= n + held;
    q <= held;
  end
endmodule
RTL
"$program" new two two.v > said
diff - <(sed -n '/FIELD(w_clk/,/FIELD(a_rst/p; /Step<V> step/,/^}/p; /  s.held/p; /rest()\|clear()/p' two/two.h) \
  << 'MODEL'
  FIELD(w_clk, 1, rises, "", "") \
  FIELD(w_rst_n, 1, flag, "", "") \
  FIELD(d, 1, flag, "", "") \
  FIELD(a_clk, 1, rises, "", "") \
  FIELD(a_rst, 1, flag, "", "")
  Step<V> step{s, {}};
  // To be written: step.outputs of this step, and of each clock what its edge makes of s.

  // a_clk rises: n, q.
  State<V> on_a_clk = step.state;
  step.state = select(is_set(in.a_clk), on_a_clk, step.state);

  // w_clk rises: held.
  State<V> on_w_clk = step.state;
  step.state = select(is_set(in.w_clk), on_w_clk, step.state);
  return step;
}
  s.held = select(!is_set(in.w_rst_n), V(0x1), s.held);
  static constexpr Inputs<Word> rest() { return {.w_rst_n = 1}; }
  static constexpr Inputs<Word> clear() { return {.w_rst_n = 0, .a_rst = 1}; }
    s.held = V(0x1);
MODEL
grep -qx 'cosim_add_design(two SOURCES two.v CLOCKS a_clk w_clk MODEL two.h)' two/CMakeLists.txt
printf 'module low(input wire ck, d, output reg q); always @(negedge ck) q <= d; endmodule\n' > low.v
"$program" new low low.v --plain > said
grep -qx 'cosim_add_design(low SOURCES low.v CLOCKS ck MODEL low.h UNPROVED)' low/CMakeLists.txt
grep -qx '  // ck falls: q.' low/low.h
printf '#include "%s"\n' {two/two,low/low}.h |
  "${CXX:-c++}" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I . -I "$sources" -x c++ -

# A port wider than a word; memories, of words that follow a parameter, of words of 100 bits, and one
# that yosys makes registers of.
cat > store.v << 'RTL'
module store #(parameter W = 8, parameter D = 6) (
    input wire clk, rst, write, input wire [2:0] at, input wire [99:0] line, input wire [W-1:0] d,
    output wire [W-1:0] q, output wire [99:0] wide, output wire [3:0] last);
  reg [W-1:0] words [0:D-1];
  reg [99:0] lines [0:3];
  reg [3:0] few [0:2];
  integer i;
  assign q = words[at];
  assign wide = lines[at[1:0]];
  assign last = few[2];
  always @(posedge clk) begin
    if (write) words[at] <= d;
    if (write) lines[at[1:0]] <= line;
    for (i = 0; i < 3; i = i + 1) if (rst) few[i] <= 0; else if (at == i) few[i] <= line[3:0];
  end
endmodule
RTL
"$program" new store store.v > said
diff - <(sed -n '/^  FIELD/p' store/store.h) << 'TABLES'
  FIELD(rst, 1, flag, "", "") \
  FIELD(write, 1, flag, "", "") \
  FIELD(at, 3, bits, "", "") \
  FIELD(line, 100, bits.words<2>(), "", "") \
  FIELD(d, p.W, bits, "", "")
  FIELD(q, p.W, bits, "", "") \
  FIELD(wide, 100, bits.words<2>(), "", "") \
  FIELD(last, 4, bits, "", "")
  FIELD(few, 4, bits.array<3>(), "", "") \
  FIELD(lines, 50, bits.array<8>().unreset(), "", "") \
  FIELD(words, p.W, bits.array<6>(p.D).unreset(), "", "")
TABLES

# A folder in place of files: what the top needs of it, packages before what uses them, headers as they
# are named; parameters that follow others are no parameters of a shape; what a reset gives.
mkdir -p tree/rtl/parts tree/rtl/include/defs tree/more
cat > tree/rtl/whole.sv << 'RTL'
`include "defs/sizes.svh"
module whole import kinds::*; #(
    parameter W = 16, parameter MODE = "SLOW", parameter D = 8, parameter KEEP = (W + 7) / 8, localparam A = $clog2(D)) (
    input wire ck_i, input wire nreset, input wire [W-1:0] d, input wire [KEEP-1:0] keep,
    output wire [A:0] level, output reg [`LANES*W-1:0] q);
  kind_t kind;
  integer i;
  reg [3:0] least;
  part #(.W(W)) p(.ck_i(ck_i), .d(d));
  library_part l(.ck_i(ck_i), .d(d[0]));
  assign level = {A + 1{kind == busy}};
  always @* begin
    least = 0;
    if (d[0]) begin
      i = 0;
      for (i = 0; i < KEEP; i = i + 1) if (keep[i]) least = i;
    end
  end
  always @(posedge ck_i) begin
    q <= {`LANES{d}} ^ least;
`ifdef SLOW
    if (d[1]) q <= 0;
`endif
    if (!nreset) begin
      kind <= idle;
      q <= 'h2a;
    end else if (d[0]) kind <= busy;
  end
endmodule
RTL
printf '`define LANES 2\n' > tree/rtl/include/defs/sizes.svh
printf 'package kinds; typedef enum logic [1:0] {busy, idle = 2} kind_t; endpackage\n' > tree/rtl/zkinds.sv
printf 'module part #(parameter W = 1)(input wire ck_i, input wire [W-1:0] d);
reg [W-1:0] r; always @(posedge ck_i) r <= d; endmodule\n' > tree/rtl/parts/part.sv
printf 'module library_part(input wire ck_i, d); reg r; always @(posedge ck_i) r <= d; endmodule\n' \
  > tree/more/library_part.v
printf 'module unneeded(input wire a; this is no Verilog\n' > tree/rtl/unneeded.v
"$program" new tree1 tree/rtl -y tree/more --top whole --define SLOW > said
diff - said << 'SAID'
tree1/: 3 inputs, 2 outputs, 4 registers; README.md has its two commands
tree1/tree1.h: next() is to be written
tree1/tree1.h: yosys cannot read the RTL, or not in 40 s: nothing is proved of it
SAID
diff - <(sed -n '/^  int\|^  FIELD/p; /cleared()/,/}/p; /rest()/p' tree1/tree1.h) << 'TABLES'
  int W = 16;
  int D = 8;
  FIELD(nreset, 1, flag, "", "") \
  FIELD(d, p.W, bits, "", "") \
  FIELD(keep, (p.W + 7) / 8, bits, "", "")
  FIELD(level, detail::bits_for(p.D) + 1, bits, "", "") \
  FIELD(q, p.W * 2, bits, "", "")
  FIELD(kind, 2, bits, "", "") \
  FIELD(l_r, 1, flag.at("l.r").unreset(), "", "") \
  FIELD(p_r, p.W, bits.at("p.r").unreset(), "", "") \
  FIELD(q, p.W * 2, bits, "", "")
  static constexpr Inputs<Word> rest() { return {.nreset = 1}; }
  static constexpr State<V> cleared() {
    State<V> s;
    s.kind = V(0x2);
    s.q = V(0x2a);
    return s;
  }
TABLES
grep -qx 'cosim_add_design(tree1 SOURCES zkinds.sv whole.sv library_part.v part.sv TOP whole INCLUDE_DIRS include DEFINES SLOW CLOCK ck_i MODEL tree1.h SHAPES "W=16 D=8" UNPROVED)' \
  tree1/CMakeLists.txt
diff tree1/include/defs/sizes.svh tree/rtl/include/defs/sizes.svh
# On a terminal a bar shows how far it is, and nothing of it is left.
if command -v script > said; then
  script -qec "'$program' new bar tree/rtl -y tree/more --top whole" shown < /dev/null > said
  grep -q '100 % \[##############################\] whole: ' said
  grep -q 'bar/: 3 inputs' said
fi
# Another shape, pins by name, a folder of headers elsewhere.
mv tree/rtl/include tree/headers
"$program" new tree2 tree/rtl tree/more/library_part.v --top whole --include tree/headers --param W=4 \
  --clock ck_i --reset nreset > said
grep -qF 'SHAPES "W=4 D=8" UNPROVED)' tree2/CMakeLists.txt
grep -q '  int W = 4;' tree2/tree2.h

# Streams. Without a file it is the filter of examples/, by another name.
"$program" new flow --stream > said
diff - said <<< 'flow/: a filter; README.md has its two commands'
for kind in v h; do
  diff <(sed 's/\<fir\>/flow/g; s/\<FIR_/FLOW_/g' "$sources/examples/fir/fir.$kind") "flow/flow.$kind"
done
shapes=$(sed -n 's/^cosim_add_design(fir .*\(SHAPES.*\)$/\1/p' "$sources/examples/fir/CMakeLists.txt")
grep -qxF "cosim_add_design(flow SOURCES flow.v MODEL flow.h $shapes" flow/CMakeLists.txt

# Of RTL: two streams in and two out, by ready and valid, by names of another kind, with directions in
# their names, with credits; widths that follow a parameter; what belongs to none of them.
cat > mixed.v << 'RTL'
module mixed #(parameter W = 5) (
    input wire clk, input wire reset_n, input wire mode,
    input wire a_valid, output wire a_ready, input wire [W-1:0] a_data, input wire a_last,
    input wire s_axis_tvalid, output wire s_axis_tready, input wire [99:0] s_axis_tdata,
    output wire sum_vld_o, input wire sum_rdy_i, output wire [W:0] sum_total_o,
    output wire done_valid, input wire done_credit, output reg [3:0] done_tag,
    output wire [1:0] level);
  always @(posedge clk) done_tag <= reset_n ? a_data[3:0] : 4'd0;
endmodule
RTL
"$program" new mixed mixed.v --stream > said
diff - said << 'SAID'
mixed/: 9 inputs, 7 outputs, as streams; README.md has its two commands
mixed/mixed.h: run() is to be written
mixed/mixed.h: mode is tied to 0; what belongs to a transaction is a field of it
mixed/mixed.h: how many credits done has is to be said
SAID
diff - <(sed -n '/^#define\|^  FIELD\|^COSIM\|stream<\|pin::/p' mixed/mixed.h) << 'TABLES'
#define MIXED_A(FIELD) \
  FIELD(data, p.W, bits, "", "") \
  FIELD(last, 1, flag, "", "")
#define MIXED_S_AXIS(FIELD) \
  FIELD(data, 100, bits.words<2>(), "", "")
#define MIXED_SUM(FIELD) \
  FIELD(total, p.W + 1, bits.at("sum_total_o"), "", "")
#define MIXED_DONE(FIELD) \
  FIELD(tag, 4, bits, "", "")
COSIM_RECORD(AData, MIXED_A, Params);
COSIM_RECORD(SAxisData, MIXED_S_AXIS, Params);
COSIM_RECORD(SumData, MIXED_SUM, Params);
COSIM_RECORD(DoneData, MIXED_DONE, Params);
    return std::tuple{stream<AData>("a"), stream<SAxisData>("s_axis").prefix("s_axis_t")};
    return std::tuple{stream<SumData>("sum").valid("sum_vld_o").ready("sum_rdy_i"), stream<DoneData>("done").credit(/* how many at the start */)};
    return std::array{pin::reset_low("reset_n"),
                      pin::tied("mode", 0),
                      pin::unread("level", 2)};
TABLES
grep -qx 'cosim_add_design(mixed SOURCES mixed.v MODEL mixed.h SHAPES "W=5" UNPROVED)' mixed/CMakeLists.txt

# A plain start and done; and what is written is a model that compiles.
"$program" new divider "$sources/tests/stream/designs/divider.v" --stream > said
diff - <(sed -n '/stream</p' divider/divider.h) << 'STREAMS'
    return stream<InData>("in").prefix("").valid("start").until("done");
    return stream<OutData>("out").prefix("").valid("done").rising();
STREAMS
sed -i 's,/[*] how many at the start [*]/,2,' mixed/mixed.h
printf '#include "%s"\n' {mixed/mixed,divider/divider,flow/flow}.h |
  "${CXX:-c++}" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I . -I "$sources" -x c++ -

# refused LINE WORDS...: that is all that it says, its status is 2, and there is no folder `made`.
refused() {
  local line="cosim: $1" said status=0
  shift
  said=$("$program" new "$@" 2>&1) || status=$?
  [[ $status == 2 && $said == "$line" && ! -e made ]] && return
  printf 'new %s: status %d, it said\n%s\nin place of\n%s\n' "$*" "$status" "$said" "$line"
  exit 1
}
# rtl BODY: a module with a clock, some inputs and outputs.
rtl() {
  printf 'module made(input wire clk, other, d, input wire [7:0] w, output reg q, r);\n%s\nendmodule\n' \
    "$1" > made.v
}
refused "NAME: is needed"
refused "NAME: 'Made' is not small letters, digits and _, a letter first" Made
refused "NAME: parity is the harness's own, in model/core/bit_strings.h" parity
refused "NAME: switch is a word of C++" switch
[[ ! -e parity && ! -e switch ]] || exit 1
refused "pair: exists" pair
refused "none.v: no such file" made none.v
rtl 'always @(posedge clk) q <= d'
refused "new: Verilator cannot read it: %Error: made.v:3:1: syntax error, unexpected endmodule" made made.v
rtl 'always @* if (other) q = d; always @(posedge clk) r <= q;'
refused "new: q: a latch" made made.v
rtl 'always @(posedge clk or posedge other) if (other) q <= 0; else q <= d;'
"$program" new made made.v > said
grep -q 'clear() { return {.other = 1}; }' made/made.h
grep -qx '  static constexpr bool asynchronous_reset = true;' made/made.h
rm -r made
rtl 'always @(posedge clk or negedge other) if (!other) q <= 0; else q <= d;
     always @(posedge clk or posedge d) if (d) r <= 0; else r <= w[0];'
"$program" new made made.v > said
diff - <(sed -n '/^constexpr State/,/^}/p; /clear()\|rest()/p' made/made.h) << 'RESET'
constexpr State<V> reset(const Params&, State<V> s, const Inputs<V>& in) {
  s.q = select(!is_set(in.other), V(0), s.q);
  s.r = select(is_set(in.d), V(0), s.r);
  return s;
}
  static constexpr Inputs<Word> rest() { return {.other = 1}; }
  static constexpr Inputs<Word> clear() { return {.other = 0, .d = 1}; }
RESET
rm -r made
# A register that resets others, behind what resets it.
rtl 'reg ready; always @(posedge clk or negedge other) if (!other) ready <= 0; else ready <= 1;
     always @(posedge clk or negedge ready) if (!ready) q <= 1; else q <= d;'
"$program" new made made.v > said
diff - <(sed -n '/^constexpr State/,/^}/p; /clear()\|rest()/p' made/made.h) << 'RESET'
constexpr State<V> reset(const Params&, State<V> s, const Inputs<V>& in) {
  s.ready = select(!is_set(in.other), V(0), s.ready);
  s.q = select(!is_set(s.ready), V(0x1), s.q);
  return s;
}
  static constexpr Inputs<Word> rest() { return {.other = 1}; }
  static constexpr Inputs<Word> clear() { return {.other = 0}; }
RESET
grep -q ' UNPROVED)$' made/CMakeLists.txt
grep -qx 'made/made.h: a register resets others at once: nothing is proved of it' said
rm -r made
rtl 'reg ready; always @(posedge clk) ready <= d;
     always @(posedge clk or negedge ready) if (!ready) q <= 1; else q <= d;'
refused "new: ready: a register that resets others at once, and no input resets anything" made made.v
rtl 'wire x = d & other; always @(posedge clk or posedge x) if (x) q <= 0; else q <= d;'
refused "new: q: an asynchronous reset by x, which is no input" made made.v
rtl 'always @(posedge clk) q <= d; always @(negedge clk) r <= d;'
refused "new: r and q: registers on both edges of clk" made made.v
rtl 'reg half; always @(posedge clk) half <= !half; always @(posedge half) q <= d;'
refused "new: q: its clock is half, which is no input" made made.v
rtl 'wire gated = clk & d; always @(posedge gated) q <= w[0]; always @(posedge other) r <= w[1];'
refused "new: q: its clock is gated, which is no input" made made.v
rtl 'always @(posedge clk) q <= d; always @(posedge other) r <= d;'
refused "new: --stream: of one clock, which rises; made has several" made made.v --stream
rtl 'wire x = !other; always @(posedge clk or posedge x) if (x) q <= 0; else q <= d;
     always @(posedge clk or negedge other) if (!other) r <= 0; else r <= d;'
"$program" new made made.v > said
grep -q 'clear() { return {.other = 0}; }' made/made.h
rm -r made
# The variable of loops in several processes is no latch, and none that only some ways write, where each
# writes it before it is read.
rtl 'integer i; reg [3:0] a, b;
     always @* begin r = 0; for (i = 0; i < 4; i = i + 1) a[i] = w[i]; end
     always @* begin b = 0; if (d) for (i = 0; i < 4; i = i + 1) b[i] = a[i] && w[i + 4]; end
     always @(posedge clk) q <= ^b;'
"$program" new made made.v > said
rm -r made
rtl 'integer i, n; reg [3:0] a;
     always @* begin a = 0; if (d) begin n = 0; for (i = 0; i < 4; i = i + 1) if (w[i]) n = i; a = n; end end
     always @(posedge clk) q <= ^a;'
"$program" new made made.v > said
rm -r made
# A word of C++ is no name of a field.
rtl 'always @(posedge clk) begin q <= d; r <= other; end'
sed -i 's/\bother\b/delete/g' made.v
"$program" new made made.v > said
grep -qF 'FIELD(delete_, 1, flag.at("delete"), "", "")' made/made.h
rm -r made
rtl 'reg mem[1:4]; always @(posedge clk) begin mem[w[2:0]] <= d; q <= mem[w[6:4]]; end'
"$program" new made made.v > said
grep -qF 'FIELD(mem, 1, flag.array<4>().unreset(), "", "")' made/made.h
rm -r made
rtl '(* nomem2reg *) reg mem[0:3]; always @* if (other) mem[w[1:0]] = d; always @(posedge clk) q <= mem[w[5:4]];'
refused "new: mem: a latch" made made.v
rtl 'always @* q = d;'
refused "new: made has no register: nothing of it is a stream" made made.v --stream
"$program" new made made.v > said
grep -q ' COMBINATIONAL MODEL made.h)$' made/CMakeLists.txt
grep -q '^#define MADE_STATE(FIELD)$' made/made.h
rm -r made
# Names that are commands, or more than names, to what reads them.
rtl 'always @(posedge clk) q <= d;'
# shellcheck disable=SC2016  # a name, not a variable
for hostile in 'x"; exec -- touch pwned; log "a.v' 'a b.v' 'a;b.v' 'a)b.v' 'a$ENV{HOME}.v'; do
  [[ -e $hostile ]] || cp made.v "$hostile"
  refused "new: '$hostile': the name of a file in a project has letters, digits and _ . + - alone" \
    made "$hostile"
done
[[ ! -e pwned ]] || { echo "the name of a file was run" && exit 1; }
mkdir -p other && printf '// none\n' > other/none.v
mkdir -p 'y"; exec -- touch pwned; log "'
cp made.v other/made.v
refused "new: 'made.v' and 'other/made.v': two files of one name" made made.v other/made.v
cp made.v 'y"; exec -- touch pwned; log "/made.v'
"$program" new made 'y"; exec -- touch pwned; log "/made.v' > said
rm -r made
[[ ! -e pwned ]] || { echo "the name of a folder was run" && exit 1; }
for own in made.h CMakeLists.txt README.md; do
  cp made.v "other/$own"
  refused "new: 'other/$own': the project has its own $own" made "other/$own"
done
printf '\xEF\xBB\xBF' | cat - made.v > other/bom.v
refused "new: 'other/bom.v': begins with a byte-order mark, which is no Verilog" made other/bom.v
rtl 'reg \q"x ; always @(posedge clk) begin \q"x <= d; q <= \q"x ; end'
refused "new: 'q\"x': an escaped name is not supported" made made.v
# A file whose name is a pattern to yosys is not another file; a field of any name compiles.
mkdir '[o]' o
cp made.v o/made.v
printf 'module made(input wire clk, V, p, Inputs, select, size, linux, EOF, index_a, a,\n' > '[o]/made.v'
printf '  output reg Table, FIELD);\nalways @(posedge clk) begin Table <= V ^ p ^ Inputs ^ select;\n' >> '[o]/made.v'
printf 'FIELD <= size ^ linux ^ EOF ^ index_a ^ a; end\nendmodule\n' >> '[o]/made.v'
"$program" new made '[o]/made.v' > said
printf '#include "made/made.h"\nint main() { return cosim::made::Inputs<cosim::Word>{}.V_ != 0; }\n' |
  "${CXX:-c++}" -std=gnu++20 -Wall -Wextra -Werror -fsyntax-only -I . -I "$sources" -x c++ -
rm -r made
rtl 'always @(posedge clk) q <= d;'
refused "--top: no file has a module 'other'" made made.v --top other
refused "--clock: 'a b' is no name in Verilog" made made.v --clock 'a b'
refused "--clock: '' is no name in Verilog" made made.v --clock clk,,other
refused "new: q: its clock is clk, and that of the design is d" made made.v --clock d
refused "new: none: the RTL has no such input, which is to be its clock" made made.v --clock none
refused "new: none: the RTL has no such input, which is to be its reset" made made.v --reset none
refused "--include: 'none': no such folder" made made.v --include none
refused "-y: 'none': no such folder" made made.v -y none
refused "--param: 'W' is not NAME=VALUE" made made.v --param W
refused "--define: '1' is not NAME or NAME=VALUE" made made.v --define 1
refused "new: the top may be made or part: --top says which" another made.v part.v
refused "new: no module in 'other/none.v'" made other/none.v
refused "--plain: does not go with --stream" made --plain --stream
rtl 'always @(posedge clk) q <= d;'
refused "new: made: no stream goes in: it has no input whose name ends in valid or vld, and not both start and done" \
  made made.v --stream
sed -i 's/ d,/ x_valid,/; s/<= d/<= x_valid/' made.v
refused "new: made: no stream comes out: it has no output whose name ends in valid or vld, and not both start and done" \
  made made.v --stream
sed -i 's/ q,/ y_valid,/; s/q <=/y_valid <=/' made.v
refused "new: made: the stream x has no port for what passes" made made.v --stream
echo "read or refused"
