#!/usr/bin/env bash
# slang_test.sh BUILD
#
# SystemVerilog that yosys cannot read, a package, an array of structs that counts upward and an assertion, is
# proved and mutated where slang is installed; where it is not a line says what to install. Status: 0 so, 1 not.
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"
sources=$(cd "$before" && realpath "$(dirname "${BASH_SOURCE[0]}")/slang") build=$(cd "$before" && realpath "$1")
build_program window_cosim "$build" "$sources"

ends 0 sweep window --hostile 10000
if [[ -e ${COSIM_SLANG:-$build/systemverilog/installed.json} ]]; then
  ends 0 prove window
  says "the RTL: read by slang, as Verilator simulates it"
  ends 0 mutate window --mutants 5
  says "5 killed, 0 proved equal, 0 survived"
else
  ends 2 prove window
  says "slang may read it: scripts/setup systemverilog installs it"
fi
