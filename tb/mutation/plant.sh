#!/usr/bin/env bash
# plant.sh FOLDER PREFIX COUNT PART PARTS DESIGN [NAME=VALUE...]
#
# COUNT mutants of a design's RTL (all there are, where these are fewer), made by yosys in all its
# modes, and every PARTS-th of them from number PART on, 1 to PARTS, planted in one Verilog module
# that has a further input: mutsel = k turns mutant k on, 0 none. Writes to FOLDER
#   mutants.txt  a line a mutant, that of mutsel = 1 first
#   mutants.v    the module, flat, its registers by their own names
#   mutants.cpp  what Verilator makes of it, the class PREFIX
set -euo pipefail

rtl=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../rtl" && pwd)
mkdir -p "$1"
folder=$(cd "$1" && pwd) prefix=$2 count=$3 part=$4 parts=$5 design=$6
parameters=("${@:7}")
parameters=("${parameters[@]/#/-chparam }")
prepare="read_verilog $design/*.v
  hierarchy -check -top $design ${parameters[*]/=/ }
  prep -flatten -top $design"

# In the folder of the RTL, so that a mutant is known by the place in its file. yosys warns where
# there are fewer mutants than asked.
cd "$rtl"
export HOME=$folder # where yosys keeps a history
yosys -q -p "$prepare; mutate -list $count -seed 1 -o $folder/all.txt" > "$folder/yosys.log" 2>&1 ||
  { cat "$folder/yosys.log" >&2 && exit 1; }
awk -v part="$part" -v parts="$parts" 'NR % parts == part % parts' "$folder/all.txt" \
  > "$folder/part.txt"
sed -E 's/^mutate //; s/-module [^ ]+ //' "$folder/part.txt" > "$folder/mutants.txt"
{
  echo "$prepare"
  awk '{ print $0, "-ctrl mutsel 16", NR }' "$folder/part.txt"
  echo "opt_clean; write_verilog -noattr $folder/mutants.v"
} > "$folder/mutants.ys"
yosys -q "$folder/mutants.ys"

cd "$folder"
sed "s/@DESIGN@/$design/" "$rtl/../tb/dut/registers.vlt.in" > registers.vlt
rm -rf verilated
verilator --cc --top-module "$design" --prefix "$prefix" --Mdir verilated -Wno-WIDTH -Wno-UNOPTFLAT \
  --x-initial unique --x-assign unique --noassert -O3 registers.vlt mutants.v
(cd verilated && printf '#include "verilated/%s"\n' *.cpp) > mutants.cpp
