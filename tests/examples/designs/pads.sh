# shellcheck shell=bash
# Mutants of the RTL whose pins are split are found or proved equal, and two versions of it are compared.
if [[ $solvers ]]; then
  ends 0 mutate pads FAULT=0 --mutants 20
  ends 0 cover pads FAULT=0 --hostile 5000 --close
  says_like 'pads.v:15: never toggles: unreachable, proved: sda[$]out'
  # shellcheck disable=SC2154  # designs_test.sh says it
  rtl=$designs/pads.v
  echo 'module CLKBUF(output O, input I); assign O = I; endmodule' > clkbuf.v
  sed 's/low ? 1.b0 : 1.bz/!low ? 1'"'bz : 1'b0/" "$rtl" > again.v
  ! cmp -s "$rtl" again.v || fails "the RTL is written in another way"
  ends 0 equiv --gold "$rtl" clkbuf.v --gate again.v clkbuf.v --top pads --reset rst
  says "pads: equal for ever"
  sed 's/assign line = low/assign line = !low/' "$rtl" > other.v
  ends 1 equiv --gold "$rtl" clkbuf.v --gate other.v clkbuf.v --top pads --reset rst
  says "sda\$en"
fi
