#!/usr/bin/env bash
# survivor_test.sh COSIM PROGRAM WORD...
#
# A mutant that no stimulus kills and no proof shows to be the same machine has survived: status 1, and
# a folder that describes it and from which it can be proved. Before that, engines that there are not
# are refused: status 2, and nothing is written.
# Status: 0 so, 1 not, 77 where a solver is not installed.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
cosim=$1
program=("${@:2}")
status=0
"${program[@]}" "$folder/results.json" --engines cec,nobody 2> "$folder/said" || status=$?
((status == 2)) || { echo "status $status with an engine that there is not" && exit 1; }
grep -qx -- "--engines 'cec,nobody': takes .*" "$folder/said"
[[ ! -e $folder/results.json && ! -e $folder/results.json.part ]]

status=0
"${program[@]}" "$folder/results.json" --unproved --failures "$folder/failures" > "$folder/said" || status=$?
((status == 1)) || { echo "status $status with survivors" && exit 1; }
survived=$(grep -c '"end": "survived"' "$folder/results.json")
kept=("$folder"/failures/*)
((survived == ${#kept[@]})) || { echo "$survived survived, ${#kept[@]} kept" && exit 1; }

for one in "${kept[@]}"; do
  grep -qF "kept in: $one" "$folder/said"
  what=$(sed -n 's/.* survived: //p' "$one/report.txt")
  grep -F "\"what\": \"${what//\\/\\\\}" "$one/report.json" > /dev/null
  grep -q 'hostile clocks' "$one/report.txt"
done
read -ra prove < <(sed -n 's|^  scripts/prove ||p' "$one/report.txt")
"$cosim" prove "${prove[@]}" | tee "$folder/proof"
grep -q '1 proved to be the same' "$folder/proof"
