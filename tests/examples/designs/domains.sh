# shellcheck shell=bash
[[ ! $solvers ]] || {
  ends 0 mutate domains FAULT=0 --mutants 1000 --list
  says ", 0 survived"
  says "-port Q"
  says_not "-port CLK"
}
