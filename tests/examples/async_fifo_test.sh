#!/usr/bin/env bash
# async_fifo_test.sh PROGRAM
#
# All small faults of a small queue between two clocks are found, or proved to be none, those at the pins of
# its memory too; none is of a clock pin. What was left out is added up by name, for its shapes have memories
# of other lengths. Status: 0 so, 1 not.
program=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"

ends 0 sweep async_fifo --hostile 20000 --report all.json
says "left out of async_fifo: r_data on $(awk '/"r_data": [0-9]/ { n += $2 } END { print n }' all.json) of the clocks"
command -v yosys > /dev/null || { echo "no yosys: no mutants" && exit 0; }
ends 0 mutate async_fifo WIDTH=1 BITS=2 --mutants 1500 --list
says ", 0 survived"
says "-port WR_EN"
says_not "CLK"
