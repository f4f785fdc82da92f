#!/usr/bin/env bash
# Each machine is elaborated at the ends of its parameters' ranges, and one beyond them it is refused
# with the sentence that says the range, by each tool and as its first error.
# Status: 0 so it is, 1 not, 77 where a tool of the RTL is not installed.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
cd "$(dirname "${BASH_SOURCE[0]}")/../../rtl"
needs verilator iverilog yosys
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
    iverilog) iverilog -Wall -g2005 -s "$top" "${@/#/-P$top.}" -o "$folder/vvp" "$top"/*.v ;;
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

# The file of a design has a line each: the parameters that are taken, or the sentence that refuses
# them, a colon and the parameters.
ranges=$(printf '%s\n' ../tests/designs/*/rtl/range.txt)
while read -r file; do
  top=$(basename "$(dirname "$(dirname "$file")")")
  while IFS= read -r line; do
    read -ra words <<< "${line#*:}"
    if [[ $line == *:* ]]; then
      refused "${line%%:*}" "$top" "${words[@]}"
    else
      taken "$top" "${words[@]}"
    fi
  done < "$file"
done <<< "$ranges"

exit $((failures > 0))
