#!/usr/bin/env bash
# streams_test.sh BUILD EXAMPLES
#
# What scripts/benchmark streams measures is built against the harness that was built in BUILD, and
# each of its loops runs once, and finds RTL and model alike. Status: 0 so, 1 not.
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=tests/support/program.sh
source "$here/../support/program.sh"
build_program streams_benchmark "$1" "$here/streams" "-DEXAMPLES=$2"
ends 0 --benchmark_min_time=0.01
for loop in bare by_hand harness sweep; do says_like "^$loop .*items_per_second="; done
says_not ERROR
