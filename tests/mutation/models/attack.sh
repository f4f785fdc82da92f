#!/usr/bin/env bash
# attack.sh BUILD_FOLDER full|slice
#
# Runs the models' tests on each of the faults planted in the models, or on every twentieth, until one
# fails. Prints a table and the faults that no test saw; writes mutation/models.json (of the slice:
# models_slice.json), an object a fault with `fault`, its number, `model`, `file`, `what`, and `seen`
# with the test, empty where none did. Status: 0 all seen, 1 not, 2 could not be run.
source "$(dirname "${BASH_SOURCE[0]}")/../../support/head.sh"
build=$1 set=$2
program=$build/tests/mutation/models/faulty_models
list=$build/tests/mutation/models/faults.txt
results=$build/mutation/models.json
[[ $set == full ]] || results=$build/mutation/models_slice.json
mkdir -p "$build/mutation"

# A fault may leave a machine that never ends. Seconds of a processor, for a busy one is slow: all
# the tests take 12.
longest=30
# KB of memory: what never ends may also grow.
largest=2000000

# Tests that take long come after the others.
long='*AgainstOracle*:ValueTypes*:*Reachable*:*Accuracy.OfALine*:*NeverWraps*'
# attack NUMBER: the test that saw the fault, and how long it took, to files of its number.
attack() {
  local number=$1 begin=$EPOCHREALTIME status=0 log=$folder/$1.log filter
  for filter in "-$long" "$long"; do
    { (ulimit -t "$longest" -v "$largest" && COSIM_FAULT=$number exec "$program" --gtest_fail_fast \
      --gtest_color=no --gtest_filter="$filter") > "$log" 2>&1; } 2> /dev/null || status=$?
    ((status == 0)) || break
  done
  case $status in
    0) ;;
    1) sed -nE 's/^\[  FAILED  \] ([^ ,]+).*/\1/p' "$log" | head -n 1 ;;
    *) sed -nE 's/^\[ RUN      \] (.*)/\1/p' "$log" | tail -n 1 ;;  # it crashed or never ended
  esac > "$folder/$number"
  awk -v a="$begin" -v b="$EPOCHREALTIME" 'BEGIN { print b - a }' > "$folder/$number.time"
}

if [[ $set == full ]] && ! "$program" --gtest_brief=1 > "$folder/log" 2>&1; then
  cat "$folder/log" >&2
  echo "attack.sh: the tests fail without a fault" >&2
  exit 2
fi

numbers=()
while IFS=$'\t' read -r number _; do
  [[ $set == full ]] || ((number % 20 == 1)) || continue
  numbers+=("$number")
  while (($(jobs -rp | wc -l) >= $(nproc))); do wait -n; done
  attack "$number" &
done < "$list"
wait

for number in "${numbers[@]}"; do
  IFS=$'\t' read -r _ model file what < <(sed -n "${number}p" "$list")
  printf '%s\t%s\t%s\t%s\t%s\t%s\n' \
    "$number" "$model" "$file" "$what" "$(< "$folder/$number")" "$(< "$folder/$number.time")"
done > "$folder/all"
awk -F'\t' '
  function pair(name, value) { return sprintf("\"%s\": \"%s\"", name, value) }
  { row = sprintf(" {\"fault\": %d, %s, %s, %s, %s}", $1, pair("model", $2), pair("file", $3),
      pair("what", $4), pair("seen", $5))
    rows = rows (NR == 1 ? "" : ",\n") row }
  END { print "[\n" rows "\n]" }' "$folder/all" > "$folder/json"
mv "$folder/json" "$results"

echo '| model | planted faults | seen without the RTL | not seen | seconds |'
echo '| --- | --- | --- | --- | --- |'
awk -F'\t' '
  !($2 in all) { order[++n] = $2 }
  { ++all[$2]; seen[$2] += $5 != ""; time[$2] += $6 }
  END {
    for (i = 1; i <= n; ++i) {
      m = order[i]
      printf "| %s | %d | %d | %d | %.0f |\n", m, all[m], seen[m], all[m] - seen[m], time[m]
    }
  }' "$folder/all"
awk -F'\t' '$5 == "" { print "not seen: " $3 ": " $4 " (COSIM_FAULT=" $1 ")"; missed = 1 }
  END { exit missed }' "$folder/all"
