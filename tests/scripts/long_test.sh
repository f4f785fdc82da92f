#!/usr/bin/env bash
# long_test.sh BUILD: every line of the files long.txt is the name of a test of this build folder.
# Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
names=$(ctest --test-dir "$1" -N | sed -n 's/^ *Test *#[0-9]*: //p')
status=0
while IFS= read -r file; do
  while IFS= read -r line; do
    grep -qE -- "$line" <<< "$names" || { echo "${file#"$root"/}: no test is called $line" && status=1; }
  done < <(sed '/^#/d; /^$/d' "$file")
done < <(find "$root/tests" -name long.txt)
exit "$status"
