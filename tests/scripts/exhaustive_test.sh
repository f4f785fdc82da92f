#!/usr/bin/env bash
# exhaustive_test.sh PROGRAM HASH_OF
#
# scripts/exhaustive on the shapes of this program, killed with all that it started and gone on with:
# its report is that of a run that nobody cut, and what was done is not done again.
# Status: 0 so, 1 not, 77 without yosys.
# Needs: dda
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
program=$1 hash_of=$2
needs yosys
cd "$folder"
cut=$folder/cut state=$folder/cut/dda.checkpoint
exhaustive() {
  exec setsid "$root/scripts/exhaustive" --program "$program" --folder "$1" dda > said 2>&1
}
whole() { (exhaustive "$1") || fails "it ends with 0"; }

# It is cut while it makes the first lanes, or just after, and where two of the sweeps are kept.
for kept in 0 2; do
  exhaustive "$cut" &
  until ((kept == 0)) || (($(grep -o '"cases":[1-9]' "$state" 2> /dev/null | wc -l) >= kept)); do
    kill -0 $! 2> /dev/null || fails "it keeps what is done, to go on from there"
    sleep 0.01
  done
  ((kept)) || sleep 0.3
  kill -9 -- -$!
  ! wait $! 2> /dev/null || fails "it is killed before its end"
  [[ ! -e $cut/dda.done ]] || fails "nothing is said to be done"
done
# The last deviation kept, with a false one in its place: it comes to the report, for that sweep is not
# run again, and all else is as nobody cut it.
deviation=$(grep -o '"value":[0-9.]*' "$state" | sed -n '4s/.*://p')
sed -i "s/:$deviation}/:1.5}/" "$state"
# With the hash of what it has now.
hash=$(sed -nE 's/.*"state":(.*)\}$/\1/p' "$state" | tr -d '\n' | "$hash_of")
sed -i -E "s/\"hash\":\"[0-9a-f]*\"/\"hash\":\"$hash\"/" "$state"
whole "$cut"
[[ ! -e $state ]] || fails "what was kept goes with the end"
whole "$folder/uncut"
sed "s/: $deviation$/: 1.5/" "$folder/uncut/dda.json" | diff - "$cut/dda.json" ||
  fails "the reports are the same"
whole "$cut"
grep -q '^dda: done before' said || fails "what is done is not done again"
