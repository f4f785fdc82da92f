# shellcheck shell=bash
# A mutant behind the two words is found from reset alone: the stimulus is kept, and without the mutant
# nothing differs on it.
if [[ $solvers ]]; then
  ends 0 mutate lock FAULT=0 --mutants 100 --list --failures lock_failures
  says_like ": killed by a stimulus from reset, clock [0-9]+, "
  says "found from reset: "
  kept=(lock_failures/lock-FAULT0-mutant-*.stim)
  ((${#kept[@]} == $(grep -c "killed by a stimulus from reset" said))) || fails "each is kept"
  ends 0 replay "${kept[0]}"
  ends 1 mutate lock FAULT=0 --mutants 100 --unproved --failures lock_failures
fi
# What no random clock reaches is asked for: a stimulus opens it, which is run, and a proof tells what
# never happens.
ends 1 cover lock FAULT=0 --hostile 2000
says_like "lock.sv:[0-9]+: never holds: "
ends 2 cover lock FAULT=0 --stimuli opened
says "--stimuli: only with --close"
ends 2 cover lock FAULT=0 --close --stimuli said/opened
says "--stimuli: 'said/opened' is no folder that can be written to"
if [[ $solvers ]]; then
  ends 0 cover lock FAULT=0 --hostile 2000 --close --stimuli opened --report closed.json
  says_like "lock.sv:[0-9]+: never toggles: unreachable, proved: both$"
  says_like "^of [0-9]+ points: [0-9]+ reached, 1 unreachable, 0 open$"
  (($(grep -c 'never' said) == 1)) || fails "all else of lock is reached"
  [[ $(jq '.[0].closed | .reached + .unreachable' closed.json) == "$(sed -nE 's/^of ([0-9]+) points.*/\1/p' said)" ]] ||
    fails "the report has the numbers"
  for stimulus in opened/*.stim; do ends 0 replay "$stimulus"; done
fi
