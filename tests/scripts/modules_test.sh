#!/usr/bin/env bash
# modules_test.sh BUILD
#
# scripts/modules --build makes a project of each module in a folder, builds it against the package that
# was built in BUILD, and says where its hostile clocks stop. Status: 0 so, 1 not, 77 without yosys.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
needs yosys
cd "$folder"
cmake --install "$1" --prefix prefix > log
mkdir rtl
# One that counts, one that does nothing, as an empty model does, one that is refused, one that has a
# name of C++'s in each of its tables, and a testbench, which is none.
cat > rtl/all.v << 'RTL'
module counts(input wire clk, rst, output reg [3:0] n);
  initial n = 0;
  always @(posedge clk) if (rst) n <= 0; else n <= n + 1;
endmodule
module nothing(input wire a, output wire q);
  assign q = a & ~a;
endmodule
module latched(input wire a, d, output reg q);
  always @* if (a) q = d;
endmodule
module words #(parameter int_t = 2) (input wire clk, rst, input wire [int_t-1:0] friend, output wire [int_t-1:0] delete);
  reg [int_t-1:0] operator;
  assign delete = operator;
  always @(posedge clk) if (rst) operator <= 0; else operator <= friend;
endmodule
module bench;
  counts c();
endmodule
RTL
status=0
"$root/scripts/modules" --list table --build prefix --only counts --only nothing --only latched \
  --only words rtl > said 2> errors || status=$?
cat said errors
[[ $status == 1 ]] # not nine of ten
diff - <(cut -f 2,4- table | sed 's/clock [0-9]*/clock N/') << 'TABLE'
counts	accepted	stops at n, clock N
latched	cosim: new: q: a latch in all.v:9	
nothing	accepted	matches
words	accepted	stops at operator_, clock N
TABLE
grep -qx '3 of 4 modules accepted, 75.0 %' said
grep -qx '0 of them do not build or run' said

# A project that does not build.
cat > broken << 'SH'
#!/bin/sh
mkdir made
printf 'cmake_minimum_required(VERSION 3.25)\nproject(made C)\nmessage(FATAL_ERROR "it is broken")\n' \
  > made/CMakeLists.txt
SH
chmod +x broken
status=0
"$root/scripts/modules" --program ./broken --build prefix --only counts rtl > said || status=$?
cat said
[[ $status == 1 ]]
grep -q '^counts .* accepted, does not build: CMake Error at CMakeLists.txt:3 (message): it is broken$' said
grep -qx '1 of them do not build or run' said

# One that is refused behind lines of its progress, and one of which nothing is proved.
cat > slow << 'SH'
#!/bin/sh
[ "$5" = nothing ] || { echo "60 s: $5: reading it"; echo "cosim: new: q: a latch"; exit 2; } >&2
mkdir made
echo "made/: 1 input, 1 output, 0 registers"
echo "made/made.h: yosys cannot read the RTL: rtl.sv:2: ERROR: syntax error: nothing is proved of it"
SH
chmod +x slow
"$root/scripts/modules" --program ./slow --only latched --only nothing rtl > said || true
cat said
grep -q '^latched .* s  cosim: new: q: a latch$' said
grep -q '^nothing .* s  accepted, yosys cannot read the RTL: rtl.sv:2: ERROR: syntax error: nothing is proved of it$' said
grep -qx '1 of them yosys cannot read' said
echo "as expected"
