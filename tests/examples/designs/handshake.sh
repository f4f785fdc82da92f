# shellcheck shell=bash
# Inputs that are assumed never to come: what they are is said everywhere, and none is tried.
rules=("a number is held until ready" "by is not 0")
ends 1 sweep handshake --hostile 20000 --report report.json --failures failures
says "any value that its rules allow on any pin on any clock"
for rule in "${rules[@]}"; do
  says "assumed of the inputs: $rule"
  grep -qF "\"$rule\"" report.json || fails "the report says: $rule"
done
stimulus 'handshake FAULT=0' 'rst valid data by' '0 0 1 9 1' '1 0 1 9 2' '2 0 0 0 1'
ends 0 replay a.stim
ends 0 replay a.stim --wave a.fst
never="inputs that break an assumption"
# Another number before the first was taken; the second rule, on a later clock.
stimulus 'handshake FAULT=0' 'rst valid data by' '0 0 1 9 1' '1 0 1 8 2'
ends 2 replay a.stim
says "designs: handshake FAULT=0: clock 1: $never: ${rules[0]}"
stimulus 'handshake FAULT=0' 'rst valid data by' '0 0 1 9 1' '1 0 1 9 2' '2 0 0 0 0'
ends 2 replay a.stim --wave a.fst
says "designs: handshake FAULT=0: clock 2: $never: ${rules[1]}"
if [[ $solvers ]]; then
  ends 0 prove handshake FAULT=0
  says "legal inputs in every state"
  for rule in "${rules[@]}"; do says "assumed of the inputs: $rule"; done
  # A number is held on the clock after that of a counterexample too, from a state that is not met soon.
  mkdir late
  # shellcheck disable=SC2154  # designs_test.sh says it
  sed 's/FAULT != 0 && by == 3.d5/\&total/' "$designs/handshake.v" > late/handshake.v
  ends 1 prove handshake FAULT=0 --rtl late --limit 2 --failures failures
  says "from this state, under these inputs"
  says "RTL as built here gives what the model gives"
fi
