#!/usr/bin/env bash
# prove.sh VERILOG CLEAR MUTANT...
#
# Whether a mutant is the same machine as the RTL without one, proved by yosys and its SAT solver:
#   after a clock that clears the machine, whatever state each of the two was in, and
#   after any clock before which it is so, whatever the inputs,
# the registers and the outputs of the two are the same and the design's invariant holds, the
# expression in invariants/DESIGN.v (none: true). Prints "MUTANT equal" where both are so, else
# "MUTANT unknown". CLEAR is what clears the machine, NAME=VALUE,... of its inputs.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
verilog=$1
read -ra clear <<< "${2//,/ }"
clear=("${clear[@]/#/-set-at 1 in_}")
shift 2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

top=$(sed -n 's/^module \([a-z0-9_]*\)(.*/\1/p' "$verilog" | head -n 1)
invariant=$here/invariants/$top.v
[[ -f $invariant ]] || { invariant=$scratch/none.v && echo 'assign holds = 1;' > "$invariant"; }
awk -v invariant="$invariant" '
  /^endmodule/ { print "(* keep *) wire holds;"; while ((getline line < invariant) > 0) print line }
  { print }' "$verilog" > "$scratch/machine.v"

# fixed NAME MUTANT: a copy of the machine that is one mutant for good.
fixed() {
  echo "copy $top $1; cd $1; delete -input mutsel; connect -set mutsel 16'd$2; opt_expr; cd .."
}

# The solver knows one clock for all registers: it cannot tell of a mutant in a clock's way.
clocked() { sed -n "$1p" "$(dirname "$verilog")/mutants.txt" | grep -q -- ' -port CLK '; }

yosys -q -l "$scratch/log" -p "
  read_verilog $scratch/machine.v; prep -top $top
  expose w:*_q w:holds; clean -purge
  $(fixed plain 0)
  $(for mutant; do
    ! clocked "$mutant" || continue
    fixed "mutant$mutant" "$mutant"
    echo "miter -equiv -make_outputs -flatten plain mutant$mutant both
      log mutant $mutant
      sat -seq 2 -prove-skip 1 ${clear[*]/=/ } -prove trigger 0 -prove gold_holds 1 both
      sat -tempinduct-inductonly -maxsteps 1 -prove trigger 0 -prove gold_holds 1 both
      delete both mutant$mutant"
  done)" > /dev/null
proved=$(awk '/^mutant [0-9]+$/ { mutant = $2 }
  /SUCCESS!/ && ++proofs[mutant] == 2 { print mutant }' "$scratch/log")
for mutant; do
  grep -qx "$mutant" <<< "$proved" && echo "$mutant equal" || echo "$mutant unknown"
done
