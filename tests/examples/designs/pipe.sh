# shellcheck shell=bash
# Registers and outputs that mean nothing on some clocks are left out there, and it is said how often.
stimulus 'pipe FAULT=0' 'rst valid data' '0 0 0 5' '1 0 0 6' '2 0 1 7' '3-9 0 0 0'
ends 0 replay a.stim --report report.json
# A number is in the first register on clock 3 and in the second on clock 4.
for field in number square result; do
  says "left out: $field on 9 of the clocks, where it means nothing"
  grep -q "\"$field\": 9" report.json || fails "the report says: $field 9"
done
says_not "never compared"
stimulus 'pipe FAULT=0' 'rst valid data' '0-6 0 0 9'
ends 0 replay a.stim --report report.json
says "never compared: result, it means nothing on any clock"
grep -q never_compared report.json || fails "the report names what was never compared"
# The table of a mismatch has no expectation where there is none.
stimulus 'pipe FAULT=1' 'rst valid data' '0 0 0 5' '1 0 1 9' '2-9 0 0 0'
ends 1 replay a.stim
says "first difference: clock 3, square"
grep -Eq '^  reg square expected +- +- +- +81 +-' said || fails "only clock 3 expects a square"
if [[ $solvers ]]; then
  ends 0 prove pipe FAULT=0
  says "compared only where it means something: result"
  says "each of 4 cases is possible"
fi
