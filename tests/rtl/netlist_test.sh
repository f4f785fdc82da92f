#!/usr/bin/env bash
# scripts/netlist proves the netlists of small machines and finds faults that are planted in them.
# Status: 0 all as expected, 1 not, 77 where yosys is not installed.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
command -v yosys > /dev/null || { echo "skipped: no yosys" && exit 77; }
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0 output=

# expect TITLE STATUS PATTERN ARGUMENTS...: scripts/netlist with these ends so and says that.
expect() {
  local title=$1 expected=$2 pattern=$3 status=0
  output=$("$root/scripts/netlist" "${@:4}" 2>&1) || status=$?
  if ((status == expected)) && grep -qE -- "$pattern" <<< "$output"; then
    echo "as expected: $title"
    return
  fi
  printf 'NOT AS EXPECTED: %s\nstatus %d for %d, and this for %s:\n%s\n' \
    "$title" "$status" "$expected" "$pattern" "$output"
  failures=$((failures + 1))
}

# fault TITLE PATTERN SED [ASSIGNMENT]: planted in the netlist of the circular machine, with an
# assignment added to its top module.
circular=$scratch/circular.v
fault() {
  sed -E "$3; /^module circular/,\$ s/^endmodule/${4:+assign $4;} endmodule/" "$circular" \
    > "$scratch/fault.v"
  expect "$1" 1 "$2" --check "$scratch/fault.v" circular W=4
}

# The first shape of each design.
while read -ra words; do
  expect "${words[0]}" 0 'ice40 .* proved$' "${words[@]}"
  grep -qE 'generic .* proved$' <<< "$output" || { echo "no generic one: ${words[*]}" && exit 1; }
done < <(awk '!/^#/ && NF && !seen[$1]++' "$root/rtl/shipped.txt")
"$root/scripts/netlist" --write "$circular" ice40 circular W=4
expect "from a file" 0 'file .* proved$' --check "$circular" circular W=4

mkdir "$scratch/bin"
printf '#!/bin/sh\nexec sha256sum /dev/zero\n' > "$scratch/bin/yosys" && chmod +x "$scratch/bin/yosys"
PATH=$scratch/bin:$PATH COSIM_NETLIST_LIMIT=1 expect "a solver at its limit" 1 \
  'undecided in 1 s of processor time; give it more: COSIM_NETLIST_LIMIT=10$' \
  --check "$circular" circular W=4

fault "an output stuck" '^ *netlist +step_x .*!$' 's/\.O\(step_x\)/.O()/' "step_x = 1'b0"
fault "an output left open" 'NOT EQUAL' 's/\.O\(step_y\)/.O()/'
fault "one bit of F wrong" '^ *netlist +f_q .*!$' 's/\.Q\(f_q\[7\]\)/.Q(lost)/' \
  'f_q[7] = lost ^ f_q[6]'
fault "two bits of a register exchanged" 'NOT EQUAL' \
  's/\.Q\(ct8_q\[1\]\)/.Q(swap)/; s/\.Q\(ct8_q\[2\]\)/.Q(ct8_q[1])/; s/\.Q\(swap\)/.Q(ct8_q[2])/'
fault "a flip-flop that no reset reaches" '^ *netlist +t16_q .*!$' \
  "/^ *SB_DFF.*t16_q/,/\);\$/ s/\.R\(.*\)/.R(1'b0)/"

expect "a netlist of another width" 1 'no verdict' --check "$circular" circular W=8
expect "no netlist" 1 'no verdict' --check /dev/null circular W=4
expect "no such design" 2 '^netlist: no such design: square' square W=4
expect "no such parameter" 2 '^netlist: circular has no parameter M' circular M=4
exit $((failures > 0))
