# shellcheck shell=bash disable=SC2154
# A replay of a stimulus by hand, and a wave, of logic that has no clock.
printf 'cosim stimulus 1\nmachine alu FAULT=1\nclock a b operation\n0 1 2 0\n1 90 3 3\nend\n' > a.stim
ends 1 replay a.stim --wave alu.fst
says "first difference: clock 1, result"
[[ -s alu.fst ]] || fails "alu is drawn"
