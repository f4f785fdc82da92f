# shellcheck shell=bash
# Registers and outputs that are not compared are said to be so, with every result.
ends 1 sweep probed --hostile 20000 --report report.json --failures failures
says "unobserved: 4 signals: debug.*, spare"
for name in debug.idle spare; do
  grep -q "\"$name\"" report.json || fails "the report names the unobserved $name"
done
# They may be anything: it is proved at its outputs.
[[ ! $solvers ]] || { ends 0 prove probed FAULT=0 && says "from reset: always the same" && says "from reset by yosys-abc"; }
