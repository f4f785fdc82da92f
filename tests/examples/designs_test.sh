#!/usr/bin/env bash
# designs_test.sh --built FOLDER | --program PROGRAM [NAME...]
#
# Installs the harness that was built in FOLDER, builds the designs of designs/ that are named, all
# where none is, against it, and tries each: hostile clocks find no difference where it is as it is
# meant (FAULT=0), and find and shrink the planted fault (FAULT=1), which the smallest stimulus shows
# again; the proof proves the one and refutes the other, or refuses both. Then designs/NAME.sh, what
# is particular to a design. PROGRAM: one that was built already. Status: 0 so, 1 not.
here=$(cd "$(dirname "$0")" && pwd)
designs=$here/designs
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"
program_of designs "$designs" "$@"

solvers=yes
command -v yosys > /dev/null || { solvers='' && echo "no yosys: nothing is proved"; }

# stimulus MACHINE COLUMNS ROW...: a.stim is one of these rows.
stimulus() {
  printf 'cosim stimulus 1\nmachine %s\nclock %s\n' "$1" "$2" > a.stim
  printf '%s\n' "${@:3}" end >> a.stim
}

# What is particular to a design, in a function: it may have variables of its own.
particular() {
  local name=$1
  # shellcheck source=/dev/null
  source "$designs/$name.sh"
}

if ((${#chosen[@]} == 0)); then
  mapfile -t chosen < <(cd "$designs" && find . -name '*.h' | sort | sed 's,^\./,,; s,\.h$,,')
fi
clocks=20000
for name in "${chosen[@]}"; do
  ends 1 sweep "$name" --hostile "$clocks" --failures failures
  grep -q "^$name FAULT=0.*: $clocks clocks" said || fails "$name without a fault matches"
  grep -q "^$name FAULT=1.*, case [0-9]*: " said || fails "the fault of $name is found"
  smallest=(failures/"$name"-FAULT1-*/smallest.stim)
  [[ -f ${smallest[0]} ]] || fails "the fault of $name is shrunk"
  ends 1 replay "${smallest[0]}"
  if [[ $solvers && -f $designs/$name.unproved ]]; then
    ends 2 prove "$name"
    says "$(< "$designs/$name.unproved")"
    (($(wc -l < said) == 1)) || fails "prove refuses $name in one line"
  elif [[ $solvers ]]; then
    ends 0 prove "$name" FAULT=0
    ends 1 prove "$name" FAULT=1 --failures failures
    says REFUTED
  fi
  [[ ! -f $designs/$name.sh ]] || particular "$name"
  echo "$name: as it should be"
done
