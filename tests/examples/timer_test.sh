#!/usr/bin/env bash
# timer_test.sh PROGRAM
#
# On the program of examples/timer, which is VHDL: the bits that are covered are those of its signals, not of
# the nets that GHDL makes.
# Status: 0 so, 1 not.
program=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"

ends 0 cover timer WIDTH=8 --hostile 10000
says_like ' toggles, 10 of 10 ways$'
echo "as it should be"
