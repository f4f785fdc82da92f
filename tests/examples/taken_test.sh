#!/usr/bin/env bash
# taken_test.sh SOURCES
#
# A design whose name the harness needs for itself is refused in one line when CMake configures, and
# none other is: a namespace of any other word in the harness's headers is in the way of none of them.
# SOURCES is the project's folder. Status: 0 so, 1 not.
set -euo pipefail

sources=$(realpath "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

# of NAME: what cosim_add_design() says of a design of that name.
of() {
  cat > add.cmake << CMAKE
cmake_minimum_required(VERSION 3.25)
set(VERILATOR_ROOT x)
include($sources/tb/package/design.cmake)
cosim_add_design($1 SOURCES none.v MODEL none.h)
CMAKE
  ! cmake -P add.cmake > said 2>&1 || exit 1
  tr -s ' \n' ' ' < said
}
fails() {
  head -20 said
  echo "not so: $*"
  exit 1
}

# A function, a class, a namespace, a template, a constant, and what a model may have itself.
while read -r name header; do
  [[ $(of "$name") == *"cosim_add_design($name): the name is the harness's own, in $header "* ]] ||
    fails "$name is refused, and $header named"
done << 'NAMES'
parity model/core/bit_strings.h
InputError model/core/input_error.h
proof tb/proof/abc.h
Stream model/core/stream.h
stall_width tb/stream/shape.h
refuse_unsteady tb/lockstep/mismatch.h
registers model/core/design.h
fmt <fmt/core.h>
NAMES
[[ $(of switch) == *"cosim_add_design(switch): the name is a word of C++"* ]] || fails "switch is refused"
[[ $(of my-fifo) == *"cosim_add_design(my-fifo): the name is not letters, digits and _, a letter first"* ]] ||
  fails "my-fifo is refused"
# Those of designs that are there, and of members, parameters and name spaces inside of others.
for path in "$sources"/{rtl/*/,examples/*/,tests/*/designs/*.h} clocks data valid mend solve; do
  name=$(basename "$path" .h)
  [[ $(of "$name") == *"SOURCES: no such file"* ]] || fails "a design may be called $name"
done

cat > names.cmake << CMAKE
include($sources/tb/package/taken.cmake)
cosim_taken_names(taken)
cosim_cpp_words(words)
foreach(name IN LISTS taken words)
  message("\${name}")
endforeach()
CMAKE
cmake -P names.cmake 2>&1 | sed 's/ .*//' | sort -u > taken
# But Verilator's, and some that are looked up by the types of their arguments.
tr ' ' '
' > words << 'WORDS'
fact_of for_each_step task_of due_of begun walked override final
WORDS
(cd "$sources" && cat model/core/*.h tb/*/*.h) | grep -oE '\b[a-zA-Z][a-zA-Z0-9_]*\b' | sort -u |
  grep -vxFf words -f taken | grep -vE '^(Verilated|VL_|vpi|Vpi|vl|COSIM_)' > free
(($(wc -l < free) > 1000)) || fails "there are words"
{
  sed 's/.*/namespace cosim::& { struct Design; }/' free
  echo '#include "tb/package/named_bench.h"'
  (cd "$sources" && printf '#include "%s"\n' model/core/*.h tb/*/*.h)
} > free.cpp
root=$(verilator --getenv VERILATOR_ROOT)
"${CXX:-c++}" -std=c++20 -fsyntax-only -w -I "$sources" -isystem "$root/include" \
  -isystem "$root/include/vltstd" free.cpp > said 2>&1 || fails "these names are taken too"
echo "refused or free"
