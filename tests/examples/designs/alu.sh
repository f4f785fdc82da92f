# shellcheck shell=bash disable=SC2154
# A replay of a stimulus by hand, and a wave, of logic that has no clock.
stimulus 'alu FAULT=1' 'a b operation' '0 1 2 0' '1 90 3 3'
ends 1 replay a.stim --wave alu.fst
says "first difference: clock 1, result"
[[ -s alu.fst ]] || fails "alu is drawn"
