#!/usr/bin/env bash
# configured_test.sh: the targets of libFuzzer can be configured. Whether they build is told by scripts/fuzz,
# with Clang.
# Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
cmake -S "$root" -B "$folder/build" -G Ninja -DCOSIM_FUZZ=ON > "$folder/out" 2>&1 ||
  { cat "$folder/out" && fails "CMake configures them"; }
for file in "$root"/tests/fuzz/targets/*.cpp; do
  target=fuzz_$(basename "$file" .cpp)
  grep -q "^build $target: phony" "$folder/build/build.ninja" ||
    grep -q "^-- ${file#"$root"/} left out: " "$folder/out" || fails "there is a target $target"
done
