#!/usr/bin/env bash
# verilate.sh FOLDER PREFIX TOP [WORD...]
#
# Of FOLDER/mutants.v, RTL with mutants in the module TOP, Verilator makes the class PREFIX: in
# FOLDER/mutants.cpp. It is given the WORDs too.
set -euo pipefail

cd "$1"
rm -rf verilated
verilator --cc --top-module "$3" --prefix "$2" --Mdir verilated -Wno-fatal -Wno-lint -Wno-style \
  --x-initial unique --x-assign unique --noassert "${@:4}" mutants.v
(cd verilated && printf '#include "verilated/%s"\n' *.cpp) > mutants.cpp
