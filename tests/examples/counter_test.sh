#!/usr/bin/env bash
# counter_test.sh PROGRAM
#
# What the sweeps of examples/counter reach of its RTL: all of it, and of few clocks a line says what
# they do not reach. Status: 0 so, 1 not.
program=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"

ends 0 cover counter W=4 --report all.json --counts left
says_like '^counter, 1 configuration: reached ([0-9]+) of \1 lines, ([0-9]+) of \2 toggles, 2 of 2 ways$'
says_not never
grep -q '"never_reached": \[\]' all.json || fails "the report says so"
verilator_coverage --write-info left.info left/counter/*/V* > /dev/null || fails "Verilator reads the counts"
ends 2 cover counter W=4 --counts left
says "--counts: left: exists; name a new folder"
ends 2 cover counter W=4 --counts none/left
says "--counts: none/left: the folder around it is not there"
# Of a clock there is no second one, after which a count could change.
ends 1 cover counter W=4 --hostile 1 --report one.json
says_like '/counter\.v:[0-9]+: never toggles: .*total\[3\]'
grep -q 'counter.v:[0-9]*: never toggles: .*total' one.json || fails "the report has it"
ends 2 cover counter W=5
says "'counter W=5' is not built"
ends 2 cover counter --hostile 0
says "--hostile: '0' is not a whole number from 1"
