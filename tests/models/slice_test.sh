#!/usr/bin/env bash
# slice_test.sh COSIM MODELS: 4 random models have no wrong verdict, nor have they with a change in the Verilog;
# and a program that always says "different", or always "equal", has some.
# Status: 0 so it is, 1 not, 77 without Icarus Verilog.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
needs iverilog yosys
export COSIM=$1 MODELS=$2
models=("$root/scripts/models" --seed 2 --count 4 --results "$folder/models")
"${models[@]}"
"${models[@]}" --change 3

# shellcheck disable=SC2016 # for the shell below
printf '#!/bin/sh\nexit $(cat %s/status)\n' "$folder" > "$folder/liar"
chmod +x "$folder/liar"
COSIM=$folder/liar
for change in '' '--change 3'; do
  rm "$folder/models/results"
  [[ $change ]] && echo 0 > "$folder/status" || echo 1 > "$folder/status"
  # shellcheck disable=SC2086 # words
  "${models[@]}" $change > "$folder/said" && fails "nothing is wrong with status $(< "$folder/status")"
  grep -q 'wrong *[1-9]' "$folder/said" || fails "it is not printed"
done
echo "as expected"
