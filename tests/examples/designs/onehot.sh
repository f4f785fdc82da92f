# shellcheck shell=bash
# The registers are the RTL's own, and are proved at the outputs.
if [[ $solvers ]]; then
  ends 0 prove onehot FAULT=0
  says "from reset: always the same"
  says_like "what the RTL asserts is so .* proved from reset by "
  says "3 of 3 claims proved, by cec and cadical, but 2 from reset by yosys-abc, checked"
  ends 1 prove onehot FAULT=1 --failures onehot_failures
  says "REFUTED from reset: clock 4, by "
  ends 1 replay onehot_failures/onehot-FAULT1-*/stimulus.stim
fi
