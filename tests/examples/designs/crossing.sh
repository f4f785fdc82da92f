# shellcheck shell=bash disable=SC2154
# What yosys cannot read is drawn all the same.
ends 1 replay "${smallest[0]}" --wave crossing.fst
[[ -s crossing.fst ]] || fails "crossing is drawn"
grep -q '{now expected}' crossing.gtkw || fails "the view of crossing has its register"
# What only Verilator reads is no finding of the others; nor do they hide one of Verilator.
ends 1 lint crossing FAULT=0
says_like "verilator -Wall  findings:"
says_like "iverilog -Wall   skipped: (it does not read this: .*crossing.sv:10: syntax error|not installed)"
[[ ! $solvers ]] || says_like "yosys check      skipped: it does not read this: .*crossing.sv:10: ERROR: syntax error"
# And cosim new, which reads by yosys where that can, makes a project of it all the same.
COSIM_SLANG=none ends 0 new made "$designs/crossing.sv"
says_like "^made/made.h: yosys cannot read the RTL: crossing.sv:[0-9]*: ERROR: .*: nothing is proved of it$"
