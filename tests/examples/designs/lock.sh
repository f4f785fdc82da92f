# shellcheck shell=bash
# A mutant behind the two words is found from reset alone: the stimulus is kept, and without the mutant
# nothing differs on it.
if [[ $solvers ]]; then
  ends 0 mutate lock FAULT=0 --mutants 100 --list --failures lock_failures
  says_like ": killed by a stimulus from reset, by .*, clock [0-9]+, "
  says "found from reset: "
  kept=(lock_failures/lock-FAULT0-mutant-*.stim)
  ((${#kept[@]} == $(grep -c "killed by a stimulus from reset" said))) || fails "each is kept"
  ends 0 replay "${kept[0]}"
  ends 1 mutate lock FAULT=0 --mutants 100 --unproved --failures lock_failures
fi
