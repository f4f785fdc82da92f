#!/usr/bin/env bash
# new_test.sh PROGRAM SOURCES
#
# `cosim new` reads ports, parameters and registers out of RTL, with --stream the streams among its
# ports. SOURCES: the project's folder.
# Status: 0 so, 1 not, 77 where yosys is not installed.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
needs yosys
program=$1 sources=$2
export COSIM_SLANG=$folder/none # as if slang is not installed
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
# Its testbench is none of it.
printf "module pair_tb #(parameter N = 2); pair dut(); initial #9 \$finish; endmodule\n" > pair_tb.v
"$program" new pair pair_tb.v pair.v part.v > said
diff - said << 'SAID'
pair_tb.v: a testbench, left out
pair/: 2 inputs, 2 outputs, 3 registers; README.md has its two commands
pair/pair.h: clock() is to be written
SAID
diff - pair/pair.h << 'MODEL'
// Golden model of pair: what every register and output is, clock by clock.
#pragma once

#include <cosim/model.h>

template <int WIDTH>
struct Pair {
  struct In {
    Bit resetn;
    UInt<WIDTH> d;
  };
  struct Out {
    UInt<WIDTH + 1> sum;
    UInt<3> low;
  };
  static constexpr auto reset = active_low<&In::resetn>;

  UInt<WIDTH> last = 0;
  Unreset<At<"one.kept", UInt<3>>> kept;
  UInt<WIDTH + 1> sum = 0;

  Out clock(const In& in) {
    // To be written: the outputs, from the registers before the edge; then the registers after it.
    const Out out{.sum = 0, .low = 0};
    if (!in.resetn) {
      last = 0;
      sum = 0;
    } else {
    }
    return out;
  }
};
MODEL
grep -qx 'cosim_add_design(pair SOURCES pair.v part.v CLOCK ck MODEL pair.h SHAPES "WIDTH=6")' \
  pair/CMakeLists.txt

# Without a proof nothing but the call differs.
"$program" new plain pair.v part.v --top pair --plain > said
diff <(sed 's/Pair/Plain/' pair/pair.h) plain/plain.h
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
diff - <(sed '1,/^struct Two/d' two/two.h) << 'MODEL'
  struct In {
    Rises w_clk;
    Bit w_rst_n;
    Bit d;
    Rises a_clk;
    Bit a_rst;
  };
  struct Out {
    Bit q;
    UInt<2> n;
  };
  static constexpr auto reset = both(active_high<&In::a_rst>, active_low<&In::w_rst_n>);

  Bit held = 1;
  UInt<2> n = 0;
  Unreset<Bit> q;

  Out clock(const In& in) {
    // To be written: the outputs, from the registers before the edge; then the registers after it.
    // Each clock takes the registers of the others as they are before it.
    const Out out{.q = 0, .n = 0};
    if (in.a_clk) {
      // n, q
    }
    if (in.w_clk) {
      // held
    }
    return out;
  }

  /// What each reset does that does not wait for a clock.
  void reset_at_once(const In& in) {
    if (!in.w_rst_n) {
      held = 1;
    }
  }
};
MODEL
grep -qx 'cosim_add_design(two SOURCES two.v CLOCKS a_clk w_clk MODEL two.h)' two/CMakeLists.txt
printf 'module low(input wire ck, d, output reg q); always @(negedge ck) q <= d; endmodule\n' > low.v
"$program" new low low.v --plain > said
grep -qx 'cosim_add_design(low SOURCES low.v CLOCKS ck MODEL low.h UNPROVED)' low/CMakeLists.txt
grep -qx '    Falls ck;' low/low.h

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
# members FILE: ports and registers.
members() { sed -nE '/clock\(/q; s/^ +(.*[>a-z] [a-zA-Z_0-9]+( = .*)?;)$/\1/p' "$1"; }
diff - <(members store/store.h) << 'MEMBERS'
Bit rst;
Bit write;
UInt<3> at;
UInt<100> line;
UInt<W> d;
UInt<W> q;
UInt<100> wide;
UInt<4> last;
static constexpr auto reset = active_high<&In::rst>;
Array<UInt<4>, 3> few = 0;
Unreset<Array<UInt<50>, 8>> lines;
Unreset<Array<UInt<W>, D>> words;
MEMBERS

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
"$program" new tree1 --define SLOW -y tree/more tree/rtl --top whole > said
diff - <(sed 's/ERROR: .*: nothing/ERROR: ... nothing/' said) << 'SAID'
tree1/: 3 inputs, 2 outputs, 4 registers; README.md has its two commands
tree1/tree1.h: clock() is to be written
tree1/tree1.h: yosys cannot read the RTL: whole.sv:2: ERROR: ... nothing is proved of it
SAID
diff - <(grep ^template tree1/tree1.h; members tree1/tree1.h) << 'MEMBERS'
template <int W, int D>
Bit nreset;
UInt<W> d;
UInt<(W + 7) / 8> keep;
UInt<clog2(D) + 1> level;
UInt<W * 2> q;
static constexpr auto reset = active_low<&In::nreset>;
UInt<2> kind = 2;
Unreset<At<"l.r", Bit>> l_r;
Unreset<At<"p.r", UInt<W>>> p_r;
UInt<W * 2> q = 0x2a;
MEMBERS
grep -qx 'cosim_add_design(tree1 SOURCES zkinds.sv whole.sv library_part.v part.sv TOP whole INCLUDE_DIRS include DEFINES SLOW CLOCK ck_i MODEL tree1.h SHAPES "W=16 D=8" UNPROVED)' \
  tree1/CMakeLists.txt
diff tree1/include/defs/sizes.svh tree/rtl/include/defs/sizes.svh
# On a terminal a line shows how far it is. The top is what the testbench has of those that may be it.
printf 'module bench(); whole dut(); endmodule\n' > tree/rtl/parts/bench.v
if command -v script > said; then
  script -qec "'$program' new bar tree/rtl -y tree/more" shown < /dev/null > said
  grep -q ' s: whole: tried 2 of [0-9]* parameters' said
  grep -q 'bar/: 3 inputs' said
fi
"$program" new bench1 tree/rtl -y tree/more > said
grep -q ' TOP whole ' bench1/CMakeLists.txt
# Another shape, pins by name, a folder of headers elsewhere.
mv tree/rtl/include tree/headers
"$program" new tree2 tree/rtl tree/more/library_part.v --top whole --include tree/headers --param W=4 \
  --clock ck_i --reset nreset > said
grep -qF 'SHAPES "W=4 D=8" UNPROVED)' tree2/CMakeLists.txt

# All of these are models that compile as they are.
{
  printf '#include "%s"\n' {two/two,low/low,pair/pair,store/store,tree1/tree1}.h
  printf 'template struct %s;\n' 'Pair<6>' 'Store<8, 6>' 'Tree1<16, 8>'
} > all.cpp
"${CXX:-c++}" -std=c++20 -Wall -Wextra -Wconversion -Wshadow -Werror -fsyntax-only -I . -I "$sources" \
  -I "$sources/model" all.cpp

# What no model has is said in a line where it is written, and nothing else.
printf '%s\n' '#include "tb/nets/number.h"' 'using V = cosim::nets::Number;' \
  'V f(V a) { if (a < 1) return a / 2; return a; }' 'V g(V a) { return a > 2 && a ? a % 3 : a << 1; }' > no.cpp
if "${CXX:-c++}" -std=c++20 -fsyntax-only -I "$sources" no.cpp 2> said; then exit 1; fi
diff - <(sed -n 's/.*error: static.*\(a model asks\|a model has no [^:]*\).*/\1/p' said | sort -u) << 'SAID'
a model asks
a model has no %
a model has no /
a model has no <<
SAID
[[ $(grep -c 'error:' said) == $(grep -c 'error: static' said) ]]

# Streams. Without a file it is the filter of examples/, by another name.
"$program" new flow --stream > said
diff - said <<< 'flow/: a filter; README.md has its two commands'
for kind in v h; do
  diff <(sed 's/\<fir\>/flow/g; s/\<Fir\>/Flow/g' "$sources/examples/fir/fir.$kind") "flow/flow.$kind"
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
diff - <(sed -n '/^template/,$p' mixed/mixed.h) << 'MODEL'
template <int W>
struct Mixed {
  struct AData {
    UInt<W> data;
    Bit last;
  };
  struct SAxisData {
    UInt<100> data;
  };
  struct SumData {
    At<"sum_total_o", UInt<W + 1>> total;
  };
  struct DoneData {
    UInt<4> tag;
  };
  static constexpr auto in() {
    return std::tuple{stream<AData>("a"), stream<SAxisData>("s_axis").prefix("s_axis_t")};
  }
  static constexpr auto out() {
    return std::tuple{stream<SumData>("sum").valid("sum_vld_o").ready("sum_rdy_i"), stream<DoneData>("done").credit(/* how many at the start */)};
  }
  static constexpr auto pins() {
    return std::array{pin::reset_low("reset_n"),
                      pin::tied("mode", 0),
                      pin::unread("level", 2)};
  }

  static std::tuple<std::vector<SumData>, std::vector<DoneData>> run(
      [[maybe_unused]] const std::vector<AData>& a,
      [[maybe_unused]] const std::vector<SAxisData>& s_axis) {
    // To be written: all that must come out, in its order.
    return {};
  }
};
MODEL
grep -qx 'cosim_add_design(mixed SOURCES mixed.v MODEL mixed.h SHAPES "W=5")' mixed/CMakeLists.txt

# A plain start and done; and what is written is a model that compiles.
"$program" new divider "$sources/tests/stream/designs/divider.v" --stream > said
diff - <(sed -n '/stream</p' divider/divider.h) << 'STREAMS'
    return stream<InData>("in").prefix("").valid("start").until("done");
    return stream<OutData>("out").prefix("").valid("done").rising();
STREAMS

# Of several clocks that of a stream is the one of a name like it, or is to be looked at.
"$program" new queue "$sources/examples/async_fifo/async_fifo.v" --stream > said
if grep -q 'is to be looked at' said; then exit 1; fi
"$program" new crosses "$sources/tests/stream/designs/crosses.v" --stream >> said
diff - <(sed -n '/stream</p' {queue/queue,crosses/crosses}.h; grep 'looked at' said; grep -o 'CLOCKS.* MODEL' {queue,crosses}/CMakeLists.txt) << 'CLOCKS'
    return stream<WData>("w").clock("w_clk");
    return stream<RData>("r").clock("r_clk");
    return stream<XData>("x").clock("fast");
    return stream<YData>("y").clock("fast");
crosses/crosses.h: the clock of x is to be looked at; it is taken to be fast
crosses/crosses.h: the clock of y is to be looked at; it is taken to be fast
queue/CMakeLists.txt:CLOCKS r_clk w_clk MODEL
crosses/CMakeLists.txt:CLOCKS fast slow MODEL
CLOCKS
sed -i 's,/[*] how many at the start [*]/,2,' mixed/mixed.h
{
  printf '#include "%s"\n' {mixed/mixed,divider/divider,flow/flow,queue/queue}.h
  printf 'template struct %s;\n' 'Mixed<5>' 'Flow<8, 1>'
} | "${CXX:-c++}" -std=c++20 -Wall -Wextra -Werror -fsyntax-only -I . -I "$sources" -I "$sources/model" -x c++ -
echo "as expected"
