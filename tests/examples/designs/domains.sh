# shellcheck shell=bash
[[ ! $solvers ]] || {
  ends 0 mutate domains FAULT=0 --mutants 60
  says ": 60 mutants: "
  says ", 0 survived"
}
