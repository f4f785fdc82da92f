# shellcheck shell=bash disable=SC2154
# Mutants too are planted and decided with the registers that drive nothing.
if [[ $solvers ]]; then
  ends 0 mutate folded FAULT=0 --mutants 12
  says "0 survived"
fi
