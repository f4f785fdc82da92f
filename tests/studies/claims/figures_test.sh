#!/usr/bin/env bash
# figures_test.sh PROGRAM: figures in README and the pages of docs/ that follow from the project's files
# or that PROGRAM counts in no time are what they say. Those of the claims have a test of their own.
# Status: 0 so it is, 1 not, with a line for each sentence or row that a page does not have.
source "$(dirname "${BASH_SOURCE[0]}")/../../support/head.sh"
program=$(realpath "$1")
cd "$root"

# says PAGE TEXT...: it has each text, wherever its lines break.
says() {
  local page text
  page=$(tr '\n' ' ' < "$1")
  for text in "${@:2}"; do
    [[ $page == *"$text"* ]] || echo "$1: does not say: $text"
  done
}

# column NUMBER FIRST PAGE: that column of the table whose first heading is FIRST.
column() {
  awk -F ' *[|] *' -v column="$(($1 + 1))" -v first="$2" '
    $2 == first { inside = 1; next }
    !/^[|]/ { inside = 0 }
    inside && $2 != "---" { print $column }' "$3"
}

shapes=$(sed '/^#/d; /^$/d' rtl/shipped.txt)
machines=$(wc -l <<< "$shapes")
files=(tests/designs/*/rtl/variants/{faults,errata,deep}/*.cmake)
model=$(grep -cvE '^ *(//.*)?$' examples/fir/fir.h)

# A solver that knows nothing: theorems on integers are counted, not proved.
printf '#!/bin/sh\necho unknown\n' > "$folder/z3"
chmod +x "$folder/z3"
theorems=$(PATH=$folder:$PATH "$program" prove --theorems 2>&1 |
  sed -n 's/^[0-9]* of \([0-9]*\) theorems proved$/\1/p') || true

finds() {
  local page file name faults kept
  says docs/interpolators/results.md "every state and input, $machines configurations up to 32 bits" \
    "the claims of the sources, $theorems theorems on the models" \
    "All $((3 * machines)) claims, of $machines machines up to 32 bits" \
    "All ${#files[@]} planted faults and misprints" \
    "Each of $((${#files[@]} - 1)) planted faults and misprints"
  says docs/interpolators/theorems.md "All $theorems are proved"
  says docs/background/proof.md "All $((3 * machines)) claims of the shipped designs, in $machines configurations"
  says docs/background/performance.md "filter is $model lines"
  for file in tests/{designs,studies}/*/mutation/faults.cmake tests/mutation/models/faults/*.cmake; do
    faults=$(grep -c '^fault(' "$file")
    name=${file%/mutation/faults.cmake}
    says docs/interpolators/results.md "| $(basename "$name" .cmake) | $faults | $faults | 0 |"
  done
  kept=$(column 5 machine docs/background/performance.md | grep -oE '[0-9.]+' | sort -n | sed -n '1p;$p' | paste -sd ' ')
  says README.md "Lockstep keeps ${kept/ / to } of the speed of the bare"
  diff <(column 1 machine docs/interpolators/netlists.md) <(echo "$shapes") | sed 's|^[<>]|docs/interpolators/netlists.md: &|' || true
}

found=$(finds)
[[ ! $found ]] || { echo "$found" && exit 1; }
echo "the figures are as the pages say"
