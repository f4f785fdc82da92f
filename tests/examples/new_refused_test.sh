#!/usr/bin/env bash
# new_refused_test.sh PROGRAM SOURCES
#
# What `cosim new` takes of small modules, and what it refuses in one line: clocks, resets, latches,
# hostile names, options. SOURCES: the project's folder.
# Status: 0 so, 1 not, 77 where yosys is not installed.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
needs yosys
program=$1 sources=$2
cd "$folder"
mkdir pair
cat > part.v << 'RTL'
module part(input wire ck, input wire [2:0] d, output wire [2:0] q);
  reg [2:0] kept;
  assign q = kept;
  always @(posedge ck) kept <= d;
endmodule
RTL

# refused LINE WORDS...: that is all that it says, its status is 2, and there is no folder `made`.
refused() {
  local line="cosim: $1" said status=0
  shift
  said=$("$program" new "$@" 2>&1) || status=$?
  [[ $status == 2 && $said == "$line" && ! -e made ]] && return
  printf 'new %s: status %d, it said\n%s\nin place of\n%s\n' "$*" "$status" "$said" "$line"
  exit 1
}
# wrong LINE OPTIONS...: that is all that it says of made.v.
wrong() { refused "new: $1" made made.v "${@:2}"; }
# rtl BODY: a module with a clock, some inputs and outputs. What was made before is gone.
rtl() {
  rm -rf made
  printf 'module made(input wire clk, other, d, input wire [7:0] w, output reg q, r);\n%s\nendmodule\n' \
    "$1" > made.v
}
refused "NAME: is needed"
refused "NAME: 'Made' is not small letters, digits and _, a letter first" Made
refused "pair: exists" pair
refused "none.v: no such file" made none.v
rtl 'always @(posedge clk) q <= d'
wrong "Verilator cannot read it: %Error: made.v:3:1: syntax error, unexpected endmodule"
rtl 'always @* if (other) q = d; always @(posedge clk) r <= q;'
wrong "q: a latch in made.v:2"
echo 'module made(input wire clk, output reg made); always @(posedge clk) made <= !made; endmodule' > made.v
wrong "made.v:1: made is the name of a signal and of its module, which Verilator cannot simulate: rename one"
rtl 'always @(posedge clk or posedge other) if (other) q <= 0; else q <= d;'
"$program" new made made.v > said
grep -qx '  static constexpr auto reset = active_high<&In::other>;' made/made.h
grep -qx '  static constexpr bool asynchronous_reset = true;' made/made.h
rtl 'always @(posedge clk or negedge other) if (!other) q <= 0; else q <= d;
     always @(posedge clk or posedge d) if (d) r <= 0; else r <= w[0];'
"$program" new made made.v > said
resets() { sed -n '/reset = /p; /void reset_at_once/,/^  }/p' made/made.h; }
diff - <(resets) << 'RESET'
  static constexpr auto reset = both(active_high<&In::d>, active_low<&In::other>);
  void reset_at_once(const In& in) {
    if (!in.other) {
      q = 0;
    }
    if (in.d) {
      r = 0;
    }
  }
RESET
# A register that resets others, behind what resets it.
rtl 'reg ready; always @(posedge clk or negedge other) if (!other) ready <= 0; else ready <= 1;
     always @(posedge clk or negedge ready) if (!ready) q <= 1; else q <= d;'
"$program" new made made.v > said
diff - <(resets) << 'RESET'
  static constexpr auto reset = active_low<&In::other>;
  void reset_at_once(const In& in) {
    if (!in.other) {
      ready = 0;
    }
    if (!ready) {
      q = 1;
    }
  }
RESET
grep -q ' UNPROVED)$' made/CMakeLists.txt
grep -qx 'made/made.h: a register resets others at once: nothing is proved of it' said
rtl 'reg ready; always @(posedge clk) ready <= d;
     always @(posedge clk or negedge ready) if (!ready) q <= 1; else q <= d;'
wrong "ready: a register that resets others at once, and no input resets anything"
rtl 'wire x = d & other; always @(posedge clk or posedge x) if (x) q <= 0; else q <= d;'
wrong "q: an asynchronous reset by x, which is no input"
rtl 'always @(posedge clk) q <= d; always @(negedge clk) r <= d;'
wrong "r and q: registers on both edges of clk"
rtl 'reg half; always @(posedge clk) half <= !half; always @(posedge half) q <= d;'
wrong "q: its clock is half, which is no input"
rtl 'wire gated = clk & d; always @(posedge gated) q <= w[0]; always @(posedge other) r <= w[1];'
wrong "q: its clock is gated, which is no input"
rtl 'always @(posedge clk) q <= d; always @(posedge other) r <= d;'
wrong "made: no stream goes in: it has no input whose name ends in valid or vld, and not both start and done" --stream
rtl 'wire x = !other; always @(posedge clk or posedge x) if (x) q <= 0; else q <= d;
     always @(posedge clk or negedge other) if (!other) r <= 0; else r <= d;'
"$program" new made made.v > said
grep -qx '  static constexpr auto reset = active_low<&In::other>;' made/made.h
# The variable of loops in several processes is no latch, and none that only some ways write, where each
# writes it before it is read.
rtl 'integer i; reg [3:0] a, b;
     always @* begin r = 0; for (i = 0; i < 4; i = i + 1) a[i] = w[i]; end
     always @* begin b = 0; if (d) for (i = 0; i < 4; i = i + 1) b[i] = a[i] && w[i + 4]; end
     always @(posedge clk) q <= ^b;'
"$program" new made made.v > said
rtl 'integer i, n; reg [3:0] a;
     always @* begin a = 0; if (d) begin n = 0; for (i = 0; i < 4; i = i + 1) if (w[i]) n = i; a = n; end end
     always @(posedge clk) q <= ^a;'
"$program" new made made.v > said
# A word of C++ is no name of a member.
rtl 'always @(posedge clk) begin q <= d; r <= other; end'
sed -i 's/\bother\b/delete/g' made.v
"$program" new made made.v > said
grep -qx '    At<"delete", Bit> delete_;' made/made.h
rtl 'reg mem[1:4]; always @(posedge clk) begin mem[w[2:0]] <= d; q <= mem[w[6:4]]; end'
"$program" new made made.v > said
grep -qx '  Unreset<Array<Bit, 4>> mem;' made/made.h
rtl '(* nomem2reg *) reg mem[0:3]; always @* if (other) mem[w[1:0]] = d; always @(posedge clk) q <= mem[w[5:4]];'
wrong "mem: a latch in made.v:2"
# Ports of both directions are split, whatever drives them; one that nothing drives is an input.
# both BODY: a module with two.
both() {
  printf 'module pad(inout p, input o, e); bufif1 b(p, o, e); endmodule
module made(input wire clk, d, inout wire a, inout [1:0] w, /* inout x */ output reg q);
%s always @(posedge clk) q <= a ^ ^w; endmodule\n' "$1" > made.v
}
# members: the ports and the registers.
members() {
  sed -nE 's/^ +(At<"[^"]*", |Unreset<)?(Bit|UInt<[0-9]>)>? ([A-Za-z_]+);$/\2 \3/p' made/made.h | paste -sd';'
}
# ports TEXT: those are the ports and the register.
ports() {
  "$program" new made made.v --top made > said
  diff - <(members) <<< "$1;Bit q;Bit q"
  cmp -s made.v made/made.v || { echo "the RTL is not as it was" && exit 1; }
  rm -r made
}
both 'assign a = d ? 1'"'"'b0 : 1'"'"'bz;'
ports 'Bit d;Bit a_in;UInt<2> w;Bit a_out;Bit a_en'
both 'assign #1 w = d ? 2'"'"'b10 : {2{1'"'"'bz}}; pad one(.p(a), .o(d), .e(q));'
ports 'Bit d;Bit a_in;UInt<2> w_in;Bit a_out;Bit a_en;UInt<2> w_out;UInt<2> w_en'
both 'wire x = d ? q : '"'"'z; assign w[0] = x, w[1] = q ? 1'"'"'bZ : q; bufif0 (a, d, q);'
ports 'Bit d;Bit a_in;UInt<2> w_in;Bit a_out;Bit a_en;UInt<2> w_out;UInt<2> w_en'
both 'assign {a, w[0]} = d ? 2'"'"'b0 : 2'"'"'bz;'
wrong "made: a: an inout port that is driven in a part of { }" --top made
both 'reg x; always @* if (d) x = 0; else x = 1'"'"'bz; assign a = x;'
wrong "made: a: an inout port that is driven by 'x', which may be z" --top made
both 'pad one(a, d, q);'
wrong "made.one: its pins are connected by position, and p is an inout port" --top made
both 'wire in; pad one(.p(in), .o(d), .e(q));'
wrong "made.one: its inout port p is connected to 'in', no inout port of made" --top made
both 'assign w = d ? 2'"'"'b0 : 2'"'"'bz; assign w[0] = q ? 1'"'"'b1 : 1'"'"'bz;'
wrong "made: w: an inout port that is driven more than once, in part" --top made
# What is wrong in a file whose ports are split is said of that file.
both 'assign a = d ? 1'"'"'b0 : 1'"'"'bz;
`default_nettype none
  assign none = d;'
status=0
"$program" new made made.v --top made 2> said || status=$?
((status == 2)) || exit 1
grep -q '^cosim: new: Verilator cannot read it: %Error: made.v:5:[0-9]*: ' said
# A module that no file has: the line says what may be done, and a blackbox has its pins as ports.
rtl 'wire [1:0] y; wire z; part in(.d(d), .o(r)); MULT #(2) m(.A(w[5:4]), .B(2'"'"'d3), .C(~d), .Y(y), .Z(z));
     always @(posedge clk) q <= ^y ^ z;'
printf 'module part(input d, output o); BUF b(.I(d), .O(o)); endmodule\n' >> made.v
wrong "made.v:5: no file has the module BUF: give a file that models it, or make a blackbox of it, whose pins become ports: cosim new --blackbox BUF, in CMake BLACKBOXES BUF" \
  --top made
sed -i 's/output reg q, r/output reg q, output r/' made.v
"$program" new made made.v --top made --blackbox MULT --blackbox BUF > said
diff - <(members) <<< 'Bit other;Bit d;UInt<8> w;UInt<2> m_Y;Bit m_Z;Bit in_b_O;Bit q;Bit r;UInt<2> m_A;Bit m_C;Bit in_b_I;Bit q'
grep -q ' BLACKBOXES MULT BUF CLOCK\| BLACKBOXES MULT BUF MODEL' made/CMakeLists.txt
rm -r made
wrong "NONE: a blackbox that made has no instance of" --top made --blackbox NONE
# A file may say which pins are outputs.
rtl 'wire y; (* keep, x="1" *) (* z *) BOX b(.A(y), .Y(d)); always @(posedge clk) q <= y;'
printf 'module BOX(input Y, output A); endmodule\n' >> made.v
"$program" new made made.v --top made --blackbox BOX > said
# shellcheck disable=SC2016 # a name with a dollar
sed -n '/struct In/,/}/p' made/made.h | grep -qx '    At<"b$A", Bit> b_A;'
! grep -q UNPROVED made/CMakeLists.txt || { echo "yosys does not read it" && exit 1; }
rtl 'wire y; BOX b(.A(d & w[0]), .Y(y)); always @(posedge clk) q <= y;'
wrong "BOX b: its pin A is connected to 'd & w[0]', whose width is unknown; connect a net or its inverse" --blackbox BOX
rtl 'wire y; BOX b(d, y); always @(posedge clk) q <= y;'
wrong "BOX b: its pins are connected by position" --blackbox BOX
rtl 'wire [3:0] y; genvar i; generate for (i = 0; i < 4; i = i + 1) begin BOX b(.A(d), .Y(y[i])); end endgenerate
     always @(posedge clk) q <= ^y;'
wrong "BOX b: instances of it in a loop" --blackbox BOX
rtl 'always @* q = d;'
wrong "made has no register: nothing of it is a stream" --stream
"$program" new made made.v > said
grep -q ' COMBINATIONAL MODEL made.h)$' made/CMakeLists.txt
grep -qx '  Out clock(\[\[maybe_unused\]\] const In& in) const {' made/made.h
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
wrong "'made.v' and 'other/made.v': two files of one name" other/made.v
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
wrong "'q\"x': an escaped name is not supported"
# A file whose name is a pattern to yosys is not another file; a field of any name compiles.
mkdir '[o]' o
cp made.v o/made.v
printf 'module made(input wire clk, in, path, low, Bit, Made, linux, EOF, std,\n' > '[o]/made.v'
printf '  output reg Array, clock);\nreg idle;\nalways @(posedge clk) begin Array <= in ^ path ^ low;\n' >> '[o]/made.v'
printf 'idle <= Bit ^ Made ^ linux; clock <= EOF ^ std ^ idle; end\nendmodule\n' >> '[o]/made.v'
"$program" new made '[o]/made.v' > said
diff - <(grep 'At<' made/made.h) << 'NAMES'
    At<"Bit", Bit> Bit_;
    At<"Made", Bit> Made_;
    At<"linux", Bit> linux_;
    At<"EOF", Bit> EOF_;
    At<"std", Bit> std_;
    At<"Array", Bit> Array_;
  Unreset<At<"Array", Bit>> Array_;
  Unreset<At<"clock", Bit>> clock_;
  Unreset<At<"idle", Bit>> idle_;
NAMES
# A name may be a word of C++, or one that the harness has itself.
cp made/made.h new_made.h
rtl 'always @(posedge clk) q <= d;'
for name in switch parity array; do "$program" new $name made.v > said; done
grep -q ' MODEL array.h STRUCT ArrayModel' array/CMakeLists.txt
printf '#include "%s"\n' new_made.h switch/switch.h parity/parity.h array/array.h > all.cpp
printf 'auto made = cosim::clocked::zero<Made::In>();\nauto array = cosim::clocked::zero<ArrayModel::In>();\n' >> all.cpp
"${CXX:-c++}" -std=gnu++20 -Wall -Wextra -Wconversion -Wshadow -Werror -fsyntax-only -I . -I "$sources" \
  -I "$sources/model" all.cpp
rtl 'always @(posedge clk) q <= d;'
refused "--top: no file has a module 'other'" made made.v --top other
refused "--clock: 'a b' is no name in Verilog" made made.v --clock 'a b'
refused "--clock: '' is no name in Verilog" made made.v --clock clk,,other
wrong "q: its clock is clk, and that of the design is d" --clock d
wrong "none: the RTL has no such input, but it is named as its clock" --clock none
wrong "none: the RTL has no such input, but it is named as its reset" --reset none
refused "--include: 'none': no such folder" made made.v --include none
refused "-y: 'none': no such folder" made made.v -y none
refused "--param: 'W' is not NAME=VALUE" made made.v --param W
refused "--define: '1' is not NAME or NAME=VALUE" made made.v --define 1
cat made.v part.v > both.v
refused "the top may be made or part: choose it with --top" another both.v
refused "no module in 'other/none.v'" made other/none.v
refused "--plain: does not go with --stream" made --plain --stream
rtl 'always @(posedge clk) q <= d;'
wrong "made: no stream goes in: it has no input whose name ends in valid or vld, and not both start and done" --stream
sed -i 's/ d,/ x_valid,/; s/<= d/<= x_valid/' made.v
wrong "made: no stream comes out: it has no output whose name ends in valid or vld, and not both start and done" --stream
sed -i 's/ q,/ y_valid,/; s/q <=/y_valid <=/' made.v
wrong "made: the stream x has no port for what passes" --stream
echo "read or refused"
