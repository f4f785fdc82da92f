#!/usr/bin/env bash
# long_test.sh BUILD: every line of the files long.txt is the name of a test of this build folder.
# All lines together are one regular expression that ctest can read, too: it takes few of ( and ).
# Every TEST written in tests/model and tests/tb is one, too: a macro or a batch of a unity build can
# lose them.
# Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
names=$(ctest --test-dir "$1" -N | sed -n 's/^ *Test *#[0-9]*: //p')
status=0
while IFS= read -r file; do
  while IFS= read -r line; do
    grep -qE -- "$line" <<< "$names" || { echo "${file#"$root"/}: no test is called $line" && status=1; }
  done < <(sed '/^#/d; /^$/d' "$file")
done < <(find "$root/tests" -name long.txt)
mapfile -t lines < <(find "$root/tests" -name long.txt -exec cat {} + | sed '/^#/d; /^$/d')
all=$(IFS='|' && echo "${lines[*]}")
short=$(ctest --test-dir "$1" -N -E "$all" | sed -n 's/^ *Test *#[0-9]*: //p')
diff <(grep -vE -- "$all" <<< "$names") - <<< "$short" || { echo "ctest leaves out others" && status=1; }
while IFS= read -r test; do
  grep -qxF -- "$test" <<< "$names" || { echo "tests: $test is written and not run" && status=1; }
done < <(find "$root/tests/model" "$root/tests/tb" -name '*.cpp' -exec sed '/push_macro/,/pop_macro/d' {} + |
  sed -nE 's/^TEST\((\w+), (\w+)\) .*/\1.\2/p')
exit "$status"
