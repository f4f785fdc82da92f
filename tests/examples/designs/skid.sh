# shellcheck shell=bash
# Lanes and mutants see what sweep and prove see: data that no reset reaches, in a state with more fields.
# The design has another name than its top module.
ends 1 sweep skid --hostile 20000 --lanes 512 --failures failures
says_like "^skid FAULT=0.*: 20[0-9]* clocks"
[[ ! $solvers ]] || ends 0 mutate skid FAULT=0 --mutants 40
