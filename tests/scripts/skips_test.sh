#!/usr/bin/env bash
# scripts/test names each test that was skipped, with its reason, and fails if the scripts should have
# prevented the reason; and says how many long tests it left out. Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
failures=0

# expect STATUS LINES TESTS [ARGUMENT]...: scripts/test on these tests of ctest ends so and has these
# lines.
expect() {
  local expected=$1 line output status=0
  printf '%s\n' 'add_test(passes "true")' "$3" > "$folder/CTestTestfile.cmake"
  output=$("$root/scripts/test" "${@:4}" --built "$folder" 2>&1) || status=$?
  ((status == expected)) || { echo "status $status for $expected" && failures=1; }
  while IFS= read -r line; do
    grep -qxF -- "$line" <<< "$output" || { echo "does not say: $line" && failures=1; }
  done <<< "$2"
  ((!failures)) || { printf '%s\n' "$output" && exit 1; }
}

skips=$'\nset_tests_properties(one PROPERTIES SKIP_RETURN_CODE 77)'
google='
set_tests_properties(one PROPERTIES SKIP_REGULAR_EXPRESSION "\\[  SKIPPED \\]")'
expect 0 "1 passed, 0 failed, 0 skipped" ""
expect 1 $'one: no <yosys> & more\n1 passed, 0 failed, 1 skipped' \
  'add_test(one "sh" "-c" "echo before; echo \"skipped: no <yosys> & more\"; exit 77")'"$skips"
expect 1 "one: no reason" 'add_test(one "sh" "-c" "exit 77")'"$skips"
expect 1 "one: no reason" $'add_test(one "true")\nset_tests_properties(one PROPERTIES DISABLED TRUE)'
expect 0 "one: not here: a folder" \
  'add_test(one "sh" "-c" "echo \"skipped: not here: a folder\"; exit 77")'"$skips"

# As GoogleTest puts it.
expect 1 "one: needs z3" 'add_test(one "printf" "a/b.cpp:61: Skipped\nneeds z3\n\n[  SKIPPED ] one\n")'"$google"
expect 0 "one: not here: a folder" \
  'add_test(one "printf" "a/b.cpp:61: Skipped\nnot here: a folder\n\n[  SKIPPED ] one\n")'"$google"

# Two of these three are long.
long='add_test(NetlistProof "false")
add_test(KilledSweep.GoesOn "false")'
expect 0 $'1 passed, 0 failed, 0 skipped\n== Left to scripts/test --all: 2 long tests' "$long"
expect 1 "1 passed, 2 failed, 0 skipped" "$long" --all
expect 1 "0 passed, 2 failed, 0 skipped" "$long" --long
echo "as expected"
