#!/usr/bin/env bash
# loops_test.sh BUILD FOLDER LOOP...
#
# What scripts/benchmark measures with the project in FOLDER is built against the harness that was
# built in BUILD, and each LOOP runs once, and finds RTL and model alike. Status: 0 so, 1 not.
here=$(cd "$(dirname "$0")" && pwd)
# shellcheck source=tests/support/program.sh
source "$here/../support/program.sh"
build_program "$2_benchmark" "$1" "$here/$2"
ends 0 --benchmark_min_time=0.01
for loop in "${@:3}"; do says_like "^$loop .*items_per_second="; done
says_not ERROR
