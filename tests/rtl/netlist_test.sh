#!/usr/bin/env bash
# netlist_test.sh PROGRAM
#
# scripts/netlist proves the netlists of small machines, by `equiv` of PROGRAM, which finds faults that
# are planted in them. Status: 0 all as expected, 1 not, 77 where yosys is not installed.
# Needs: circular
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
program=$(realpath "$1")
needs yosys
export COSIM_FAILURES=$folder/failures
failures=0 output=

# expect TITLE STATUS PATTERN COMMAND...: it ends so and says that.
expect() {
  local title=$1 expected=$2 pattern=$3 status=0
  output=$("${@:4}" 2>&1) || status=$?
  if ((status == expected)) && grep -qE -- "$pattern" <<< "$output"; then
    echo "as expected: $title"
    return
  fi
  printf 'NOT AS EXPECTED: %s\nstatus %d for %d, and this for %s:\n%s\n' \
    "$title" "$status" "$expected" "$pattern" "$output"
  failures=$((failures + 1))
}

# check FILE W: the netlist in a file against the circular machine of W bits.
# shellcheck disable=SC2317  # called by expect
check() {
  "$program" equiv --gold "$root"/rtl/circular/*.v --gate "$1" --top circular \
    --gold-param "W=$2" --netlists
}

# fault TITLE SED [ASSIGNMENT]: planted in the netlist of the circular machine, with an assignment added
# to its top module.
circular=$folder/circular.v
fault() {
  sed -E "$2; /^module circular/,\$ s/^endmodule/${3:+assign $3;} endmodule/" "$circular" \
    > "$folder/fault.v"
  expect "$1" 1 '^circular: different' check "$folder/fault.v" 4
}

# The first shape of each design.
netlist=$root/scripts/netlist
while read -ra words; do
  expect "${words[0]}" 0 "^${words[*]} ice40" "$netlist" --program "$program" "${words[@]}"
  (($(grep -c "^  ${words[0]}: equal for ever" <<< "$output") == 2)) ||
    { echo "not two are proved: ${words[*]}" && exit 1; }
done < <(awk '!/^#/ && NF && !seen[$1]++' "$root/rtl/shipped.txt")
"$netlist" --write "$circular" ice40 circular W=4
expect "from a file" 0 'equal for ever, by registers by name' check "$circular" 4

fault "an output stuck" 's/\.O\(step_x\)/.O()/' "step_x = 1'b0"
fault "an output left open" 's/\.O\(step_y\)/.O()/'
f='\\accumulator\.f_q ' ct8='\\counter8\.ct8_q '
fault "one bit of F wrong" "s/\.Q\(($f)\[6\]\)/.Q(lost)/" \
  '\\accumulator.f_q [6] = lost ^ \\accumulator.f_q [5]'
fault "two bits of a register exchanged" \
  "s/\.Q\(($ct8)\[1\]\)/.Q(swap)/; s/\.Q\(($ct8)\[2\]\)/.Q(\1[1])/; s/\.Q\(swap\)/.Q(\\\\counter8.ct8_q [2])/"
fault "a flip-flop that no reset reaches" \
  "/^ *SB_DFF.*t16_q/,/\);\$/ s/\.R\(.*\)/.R(1'b0)/"
expect "a netlist of another width" 2 '^cosim: ' check "$circular" 8
expect "no netlist" 2 '^cosim: ' check /dev/null 4
expect "no such design" 2 '^netlist: no such design: square' "$netlist" square W=4
expect "no such parameter" 2 '^netlist: circular has no parameter M' "$netlist" circular M=4
exit $((failures > 0))
