#!/usr/bin/env bash
# Each machine is elaborated at the ends of its parameters' ranges, and one beyond them it is refused
# with the sentence that says the range, by each tool and as its first error.
# Status: 0 so it is, 1 not, 77 where a tool of the RTL is not installed.
set -euo pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../../rtl"
for tool in verilator iverilog yosys; do
  command -v "$tool" > /dev/null || { echo "skipped: no $tool" && exit 77; }
done
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

# elaborate TOOL TOP NAME=VALUE...
elaborate() {
  local tool=$1 top=$2 && shift 2
  local chparam=("${@/#/-chparam }")
  case $tool in
    verilator)
      verilator --lint-only -Wall --top-module "$top" "${@/#/-G}" "$top"/*.v 2>&1 |
        sed -E '/^- (V e r i l a t i o n|Verilator:) /d' # what newer ones report of their work
      ;;
    iverilog) iverilog -Wall -g2005 -s "$top" "${@/#/-P$top.}" -o "$scratch/vvp" "$top"/*.v ;;
    yosys) yosys -q -p "read_verilog $top/*.v; hierarchy -check -top $top ${chparam[*]/=/ }" ;;
  esac 2>&1
}

fail() {
  printf 'NOT SO: %s\n%s\n' "$1" "$2"
  failures=$((failures + 1))
}

# taken TOP NAME=VALUE...
taken() {
  local tool output
  for tool in verilator iverilog yosys; do
    output=$(elaborate "$tool" "$@") || output+=$'\n'"status $?"
    [[ ! $output ]] || fail "$tool takes $*" "$output"
  done
}

# refused SENTENCE TOP NAME=VALUE...
refused() {
  local sentence=$1 tool output && shift
  for tool in verilator iverilog yosys; do
    if output=$(elaborate "$tool" "$@"); then
      fail "$tool refuses $*" "$output"
    elif [[ $(grep -im1 'error' <<< "$output") != *"$sentence"* ]]; then
      fail "$tool says of $*: $sentence" "$output"
    fi
  done
}

for top in circular dda; do
  taken "$top" W=2
  taken "$top" W=32
  refused "${top}_needs_2_le_W_le_32" "$top" W=1
  refused "${top}_needs_2_le_W_le_32" "$top" W=33
done

taken linear M=2 N=1
taken linear M=32 N=31
taken linear M=7 N=1
for shape in "M=5 N=0" "M=5 N=5" "M=33 N=30" "M=8 N=1"; do
  read -ra words <<< "$shape"
  refused linear_needs_1_le_N_lt_M_le_32_and_M_minus_N_le_6 linear "${words[@]}"
done

exit $((failures > 0))
