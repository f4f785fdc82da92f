# shellcheck shell=bash disable=SC2154
# Registers and outputs that are not compared are said to be so, with every result.
ends 1 sweep probed --hostile 20000 --report report.json --failures failures
says "unobserved: 4 signals: debug.*, spare"
for name in debug.idle spare; do
  grep -q "\"$name\"" report.json || fails "the report names the unobserved $name"
done
# They may be anything: it is proved at its outputs.
[[ ! $solvers ]] || { ends 0 prove probed FAULT=0 && says "from reset: always the same" && says "from reset by yosys-abc"; }
# A mutant that has a way only to them is told apart: those of the lines that make them, but for what
# changes no net, and no others.
if [[ $solvers ]]; then
  ends 0 mutate probed FAULT=0 --mutants 80 --list
  says_like "[1-9][0-9]* killed, .* survived, [1-9][0-9]* can reach nothing that is compared$"
  first=$(grep -n '^module probed_debug' "$designs/probed.v" | cut -d: -f1)
  spare=$(grep -n 'assign spare' "$designs/probed.v" | cut -d: -f1)
  sed -nE 's/^  [0-9]+: .*-src [^ ]*probed\.v:([0-9]+).*: ([a-z]+).*/\1 \2/p' said > ends_by_line
  awk -v first="$first" -v spare="$spare" '
    { own = $1 >= first || $1 == spare }
    own && $2 == "reaches" { ++apart }
    own ? $2 !~ /^(reaches|proved)$/ : $2 == "reaches" { print; wrong = 1 }
    END { exit wrong || apart < 20 }' ends_by_line ||
    fails "mutants of what is not compared are told apart: $(cat ends_by_line)"
fi
