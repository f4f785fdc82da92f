#!/usr/bin/env bash
# equiv_test.sh COSIM PROGRAM SHAPE COUNT NETS
#
# `cosim equiv` says of each of COUNT mutants of a shape, beside the RTL without a mutant, what PROGRAM,
# the campaign, says: killed is different, equivalent is equal. NETS, a pattern of yosys, has the
# registers that lockstep sees: they are outputs here. One of each kind at least is among them. A fault of
# a clock is another machine too, which equiv refuses to compare.
# Status: 0 so, 1 not, 77 where a tool is not installed.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
needs yosys
cosim=$1 program=$2 shape=$3 count=$4 nets=$5

"$program" "$shape" "$count" "$folder/results.json"
"$program" "$shape" "$count" --verilog "$folder/planted.v"
HOME=$folder yosys -q -p "read_verilog $folder/planted.v; proc; expose w:$nets
  write_verilog -noattr $folder/mutants.v"

# mutant K: the RTL with that one alone.
mutant() {
  sed -E "/^module /,/;\$/s/, mutsel\\b//; s/^  wire \\[15:0\\] mutsel;/&assign mutsel = $1;/; /^  input .*mutsel;/d" \
    "$folder/mutants.v"
}
mutant 0 > "$folder/old.v"

# what_is K WORD: what equiv says of mutant K, if that is not what the campaign does.
what_is() {
  local status=0
  mutant "$1" > "$folder/new$1.v"
  "$cosim" equiv --gold "$folder/old.v" --gate "$folder/new$1.v" --top "${shape%% *}" --netlists --jobs 2 \
    --failures "$folder/kept$1" > "$folder/said$1" 2>&1 || status=$?
  case $2$status in
    killed1 | equivalent0) ;;
    killed2) grep -Eq 'both edges of|a clock that is no input' "$folder/said$1" ;;
    *) echo "mutant $1 is $2: equiv ends with $status: $(tail -1 "$folder/said$1")" ;;
  esac
}
export -f mutant what_is
export cosim folder shape

sed -nE 's/^ *"end": "(.*)",?$/\1/p' "$folder/results.json" > "$folder/ends"
sort "$folder/ends" | uniq -c
[[ $(sort -u "$folder/ends" | paste -sd ' ') == "equivalent killed" ]]
# shellcheck disable=SC2016 # what bash is given
nl -ba "$folder/ends" | xargs -P "$(nproc)" -L 1 bash -c 'what_is "$1" "$2"' what_is > "$folder/other"
cat "$folder/other"
[[ ! -s $folder/other ]]
