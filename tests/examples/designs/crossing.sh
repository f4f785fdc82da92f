# shellcheck shell=bash disable=SC2154
# What yosys cannot read is drawn all the same.
ends 1 replay "${smallest[0]}" --wave crossing.fst
[[ -s crossing.fst ]] || fails "crossing is drawn"
grep -q '{now expected}' crossing.gtkw || fails "the view of crossing has its register"
# And cosim new, which reads by yosys, refuses it in a line.
ends 2 new made "$designs/crossing.sv"
says "new: yosys cannot read it: $designs/crossing.sv:10: ERROR: syntax error"
