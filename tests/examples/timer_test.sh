#!/usr/bin/env bash
# timer_test.sh PROGRAM
#
# On the program of examples/timer, which is VHDL: the bits that are covered are those of its signals, not of
# the nets that GHDL makes; and a proof rests on what GHDL says of the VHDL itself, not on the Verilog made of it.
# Status: 0 so, 1 not.
program=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"

ends 0 cover timer WIDTH=8 --hostile 10000
says_like ' toggles, 10 of 10 ways$'
ends 0 prove timer WIDTH=8
says_like 'the RTL: read by yosys, as GHDL simulates it on [0-9]+ clocks'
echo "as it should be"
