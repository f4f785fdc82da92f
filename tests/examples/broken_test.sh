#!/usr/bin/env bash
# broken_test.sh PREFIX
#
# A misspelt name of what a model may have stops the build. One design that cannot be used stops nothing
# of the others of its program, and where it is asked for it ends in its line: one whose table lacks a
# register, and one that yosys cannot read. PREFIX: where the harness is installed. Status: 0 so, 1 not.
prefix=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"

# as NAME LINE FILE: the counter by another name, with one more line.
cp "$root"/examples/counter/counter.* .
as() {
  sed "s/counter/$1/g; s/endmodule/  $2\nendmodule/" counter.v > "$3"
  sed "s/counter/$1/g; s/Counter/${1^}/g" counter.h > "$1.h"
}
as lacking 'reg more; always @(posedge clk) more <= en \& !more;' lacking.v
as unread 'assert property (@(posedge clk) rst || 1);' unread.sv
sed '/^cosim_add_program/i\
cosim_add_design(lacking SOURCES lacking.v MODEL lacking.h SHAPES "W=4")\
cosim_add_design(unread SOURCES unread.sv MODEL unread.h SHAPES "W=4")' \
  "$root/examples/counter/CMakeLists.txt" > CMakeLists.txt
if ! cmake -S . -B build -G Ninja "-DCMAKE_PREFIX_PATH=$prefix" > log 2>&1 ||
  ! cmake --build build >> log 2>&1; then
  tail -50 log
  exit 1
fi
program=$folder/build/counter_cosim
if grep -q _machines log; then fails "what only a proof needs waits for one"; fi

# A misspelt name stops the build.
sed -i 's/auto reset\b/auto resett/' counter.h
if cmake --build build > said 2>&1; then fails "it does not build"; fi
says "counter.h:17: resett in struct Counter means nothing: is reset meant?"
sed -i 's/resett/reset/' counter.h
cmake --build build > log 2>&1 || fails "it builds again"

line="counter_cosim: lacking W=4: the RTL has a register more that is neither in the model nor in \
unobserved"
ends 0 sweep counter --hostile 1000
says_not lacking
ends 0 prove counter
ends 2 sweep lacking --hostile 1000
[[ $(< said) == "$line" ]] || fails "sweep says: $line"
ends 2 prove lacking
[[ $(< said) == "$line" ]] || fails "prove says: $line"
ends 0 sweep unread --hostile 1000
ends 2 prove unread
(($(wc -l < said) == 1)) || fails "it is a line"
says "unread.sv:"
ends 2 list
says "$line"
says "  counter W=8"
ends 2 prove
says "$line"
says_like "^counter_cosim: .*unread.sv:[0-9]+: ERROR"
says_like "^counter W=8 +base case: a reset makes them the same"
says "6 of 6 claims proved, by cec and cadical"

# RTL that is changed is read again when it is built: a register more escapes nobody.
sed -i '/reg more/d' lacking.v
sed -i 's/^endmodule/  reg late; always @(posedge clk) late <= en;\n&/' counter.v
cmake --build build > log 2>&1 || fails "it builds again"
ends 0 sweep lacking --hostile 1000
ends 2 sweep counter --hostile 1000
says "counter W=4: the RTL has a register late that is neither in the model nor in unobserved"
echo "as it should be"
