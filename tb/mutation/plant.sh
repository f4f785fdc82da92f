#!/usr/bin/env bash
# plant.sh FOLDER PREFIX TOP COUNT [WORD...]
#
# COUNT, a number or a file that holds it, of mutants of a design's RTL (all there are, where these are
# fewer), made by yosys in all its modes and planted in one Verilog module that has a further input:
# mutsel = k turns mutant k on, 0 none. In FOLDER are
#   read.ys      commands of yosys that read the RTL, to its hierarchy; file names as seen from the
#                folder this is run in, so that a mutant is known by the place in its file
#   kept.txt     where it is there: the nets of the registers, which keep their names
# and it writes
#   mutants.txt  a line a mutant, that of mutsel = 1 first
#   mutants.v    the module, flat
#   mutants.cpp  what Verilator makes of it, the class PREFIX, given the WORDs too
set -euo pipefail

folder=$(cd "$1" && pwd)
[[ $folder != *[^A-Za-z0-9_./+=,@%~-]* ]] ||
  { echo "plant.sh: $folder: yosys cannot be given that name" >&2 && exit 1; }
prefix=$2 top=$3 count=$4
[[ ! -f $count ]] || count=$(< "$count")
words=("${@:5}")
kept=''
while IFS= read -r net; do
  name=${net##*.}
  kept+=" w:$name w:$name[[]* w:*.$name w:*.$name[[]*" # of a memory that becomes registers, each
done < <([[ ! -f $folder/kept.txt ]] || cat "$folder/kept.txt")
prepare="$(cat "$folder/read.ys")
  ${kept:+setattr -set keep 1 $kept}
  prep -flatten -top $top; chformal -remove; opt_clean"

# yosys warns where there are fewer mutants than asked.
export HOME=$folder # where yosys keeps a history
yosys -q -p "$prepare; mutate -list $count -seed 1 -o $folder/all.txt" > "$folder/yosys.log" 2>&1 ||
  { cat "$folder/yosys.log" >&2 && exit 1; }
# A memory that is read without a clock is to have constants there.
sed -i -E '/-port \\?RD_(EN|ARST|SRST) /d' "$folder/all.txt"
perl -pe 's/^mutate //; s/-module \S+ //; s/\Q$ENV{PWD}\E\///g' "$folder/all.txt" > "$folder/mutants.txt"
{
  echo "$prepare"
  awk '{ print $0, "-ctrl mutsel 16", NR }' "$folder/all.txt"
  echo "opt_clean; write_verilog -noattr $folder/mutants.v"
} > "$folder/mutants.ys"
yosys -q "$folder/mutants.ys"

bash "$(dirname "${BASH_SOURCE[0]}")/verilate.sh" "$folder" "$prefix" "$top" "${words[@]}"
