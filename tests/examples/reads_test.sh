#!/usr/bin/env bash
# What is compiled anew for a user's design reads no more of the harness than it needs: a test by hand the
# few headers of directed.h, the lists of a program one each, a design without streams nothing of
# streams. Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
cd "$folder"

# reads TEXT: the headers in tb/ that a file of that text reads, those of Verilator left out, in one line.
reads() {
  printf '%s\n' "$1" > file.cpp
  "${CXX:-c++}" -std=c++20 -I"$root" -MM -MG file.cpp | tr -s '\\ ' '\n' |
    sed -n "s,^$root/tb/,,p" | LC_ALL=C sort -u | paste -sd ' '
}
# is EXPECTED ACTUAL
is() { [[ $1 == "$2" ]] || fails "it reads $2, and not just $1"; }

is "sim/by_hand.h sim/directed.h sim/list.h sim/present_test.h sim/stimulus.h" \
  "$(reads '#include "tb/sim/directed.h"')"
is "sim/present_test.h" "$(reads "$(grep '#include "tb' "$root/tb/package/named_gtest.h.in")")"
is "sim/list.h" "$(reads "$(cat "$root/tb/package/benches.cpp.in")")"
is "cli/built.h" "$(reads "$(cat "$root/tb/package/program.cpp.in")")"
bench='#include "tb/package/named_bench.h"'
[[ $(reads "$bench") != *stream/* ]] || fails "a design without streams reads of streams: $(reads "$bench")"
[[ $(reads '#include "model/clocked/stream.h"'$'\n'"$bench") == *stream/stream_bench.h* ]] ||
  fails "a design with streams reads nothing of streams"
echo "as expected"
