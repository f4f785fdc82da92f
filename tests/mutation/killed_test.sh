#!/usr/bin/env bash
# killed_test.sh PROGRAM WORD...
#
# A run over mutants, killed at 12 random moments, ends with the same results as one that was not,
# except for the seconds; its results file is never incomplete.
# Status: 0 so, 1 not, 77 where a solver is not installed.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
needs yosys

program=("$@")

# results FILE: what must be the same.
results() { grep -v '"seconds"' "$1"; }

begin=${EPOCHREALTIME//[!0-9]/}
"${program[@]}" "$folder/expected.json"
# Milliseconds: long enough to keep a checkpoint, and most runs are killed, for theirs is one thread.
most=$(((${EPOCHREALTIME//[!0-9]/} - begin) / 2000))
kills=0 gone_on=0
for ((i = 0; i < 12; ++i)); do
  [[ ! -e $folder/results.json.part ]] || gone_on=$((gone_on + 1))
  "${program[@]}" "$folder/results.json" --jobs 1 &
  child=$!
  moment=$((RANDOM % most))
  sleep "$((moment / 1000)).$(printf '%03d' $((moment % 1000)))"
  kill -KILL "$child" 2> /dev/null || true
  status=0
  wait "$child" 2> /dev/null || status=$?
  ((status != 137)) || kills=$((kills + 1))
  [[ -e $folder/results.json ]] || continue
  diff <(results "$folder/expected.json") <(results "$folder/results.json")
  rm "$folder/results.json"
done
"${program[@]}" "$folder/results.json"
diff <(results "$folder/expected.json") <(results "$folder/results.json")
[[ ! -e $folder/results.json.part ]]
echo "killed $kills times, gone on from a checkpoint $gone_on times"
((kills >= 4 && gone_on >= 1))
