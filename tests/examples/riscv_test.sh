#!/usr/bin/env bash
# riscv_test.sh PROGRAM
#
# What a program of examples/riscv does beside its CTest tests: the cases of its transactions, in a
# verdict and in cover, how programs are drawn, and a failure as an assembler has it.
# Status: 0 so, 1 not.
program=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"

# An instruction or two meet few of the cases; a long sweep meets all of them.
ends 0 sweep core --hostile 40 --report few.json
says_like '^cases: [0-9]* of 56 happened$'
says_like '^never happened: [0-9]* more, which --report names$'
grep -q '"retired: a store behind a load": 0' few.json || fails "the report names what never happened"
ends 0 sweep core --hostile 200000 --report all.json --junit all.xml
says_like '^cases: ([0-9]+) of \1 happened$'
grep -q '"retired: a branch by 4": [1-9]' all.json || fails "the report counts a case"
grep -q 'tests="1" failures="0" errors="0"' all.xml || fails "a sweep is a test of JUnit"

ends 1 cover core --hostile 40
says "never happens: retired: a store behind a load"

ends 0 list --drawn
says_like '^step: 1[0-9]* transactions in '
says_like '^  step_op: addi 2[.][0-9] %, slti 2[.]'
