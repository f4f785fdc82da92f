#!/usr/bin/env bash
# lanes_test.sh PROGRAM [DESIGN...]
#
# Every design of a program, or those named, on the same hostile clocks one case at a time and in 64
# lanes: the same report and the same end. Those that do not run in lanes say why in one line. As a
# regression in lanes the report is the same in every byte, however it is cut.
# Status: 0 so, 1 not.
program=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"
shift

ends 0 list
designs=("$@")
((${#designs[@]})) || mapfile -t designs < <(sed -n 's/^\([a-z][a-z0-9_]*\)[:,].*/\1/p' said)
for design in "${designs[@]}"; do
  status=0
  words=(sweep "$design" --hostile 200000 --jobs 2)
  "$program" "${words[@]}" --lanes 0 --report alone.json > alone 2>&1 || status=$?
  together=0
  "$program" "${words[@]}" --lanes 64 --report together.json > said 2>&1 || together=$?
  if ((together == 2 && $(wc -l < said) == 1)) && grep -q ': does not run in lanes: ' said; then
    cat said
    continue
  fi
  ((together == status)) || fails "$design ends with $status in lanes; it is $together"
  cmp -s together.json alone.json ||
    fails "$design has the same report in lanes: $(diff alone.json together.json | head -5)"
  printf '{"format": 1, "name": "n", "seed": 7, "tasks": [{"name": "a", "sweep": "%s", %s}]}' \
    "$design" '"hostile": 200000, "lanes": true' > plan.json
  for shards in 1 2 3 5; do
    ends "$status" regress plan.json --folder "$design.$shards" --shards "$shards"
    for file in report.json report.txt; do
      cmp -s "$design.$shards/$file" "$design.1/$file" ||
        fails "$design has the same $file of $shards shards as of 1:" \
          "$(diff "$design.1/$file" "$design.$shards/$file" | head -5)"
    done
    # Shards behind the first failure may have failed too.
    for file in "$design.1/failures"/*/{stimulus,smallest}.stim; do
      [[ ! -e $file ]] || cmp -s "$file" "$design.$shards/${file#*/}" ||
        fails "$design has the same ${file#*/} of $shards shards as of 1"
    done
  done
  echo "$design: the same in lanes, $(grep -c . alone) lines, and however it is cut"
done
