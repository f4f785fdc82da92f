#!/usr/bin/env bash
# gtest_test.sh
#
# What cosim_add_gtest() cannot do is one line when CMake runs. Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/head.sh"
functions=$(cd "$(dirname "$0")/../../tb/package" && pwd)/design.cmake
cd "$folder"

# refused LINE CALL: the call ends CMake, and that is what it says.
refused() {
  local said
  printf 'include("%s")\ncosim_add_gtest(%s)\n' "$functions" "$2" > call.cmake
  if said=$(cmake -P call.cmake 2>&1) || [[ $(tr -s ' \n' ' ' <<< "$said") != *" $1 "* ]]; then
    printf 'cosim_add_gtest(%s): it said\n%s\nin place of\n%s\n' "$2" "$said" "$1"
    exit 1
  fi
}
refused "cosim_add_gtest(a): needs PROGRAM" "a SOURCES a.cpp"
refused "cosim_add_gtest(a): needs SOURCES" "a PROGRAM b"
refused "cosim_add_gtest(a): unknown argument c.cpp" "a c.cpp PROGRAM b SOURCES a.cpp"
refused "cosim_add_gtest(a): PROGRAM b is no program of cosim_add_program()" "a PROGRAM b SOURCES a.cpp"
echo "refused"
