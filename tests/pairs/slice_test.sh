#!/usr/bin/env bash
# slice_test.sh COSIM PAIRS: 20 random pairs have no wrong verdict; and one that always says "equal", or
# always "different", has some, and a generator that crashes too; and the generator writes 300 other pairs.
# Status: 0 so it is, 1 not, 77 without Icarus Verilog.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
needs iverilog yosys
export COSIM=$1 PAIRS=$2
"$root/scripts/pairs" --count 20 --jobs 2 --results "$folder/right"

# shellcheck disable=SC2016 # for the shell below
printf '#!/bin/sh\nexit $(cat %s/status)\n' "$folder" > "$folder/liar"
chmod +x "$folder/liar"
for status in 0 1; do
  echo $status > "$folder/status"
  COSIM=$folder/liar "$root/scripts/pairs" --count 20 --results "$folder/liar$status" > said && fails "status $status"
  grep -q 'wrong *[1-9]' said || fails "nothing is wrong"
done

# shellcheck disable=SC2016 # for the shell below
printf '#!/bin/sh\nkill -SEGV $$\n' > "$folder/crashes"
chmod +x "$folder/crashes"
PAIRS=$folder/crashes "$root/scripts/pairs" --count 2 --results "$folder/none" > said 2>&1 &&
  fails "the generator crashes, and the status is 0"
grep -q 'wrong *2' said || fails "the crash of the generator is not reported"
for seed in {100001..100300}; do
  "$PAIRS" "$seed" "$folder/pair" 1 || fails "the generator ends with status $? for seed $seed"
done
echo "as expected"
