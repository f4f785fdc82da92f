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
never="inputs that are assumed never to come; the rule is"
# Another number before the first was taken; the second rule, on a later clock.
stimulus 'handshake FAULT=0' 'rst valid data by' '0 0 1 9 1' '1 0 1 8 2'
ends 2 replay a.stim
says "designs: handshake FAULT=0: clock 1: $never: ${rules[0]}"
stimulus 'handshake FAULT=0' 'rst valid data by' '0 0 1 9 1' '1 0 1 9 2' '2 0 0 0 0'
ends 2 replay a.stim --wave a.fst
says "designs: handshake FAULT=0: clock 2: $never: ${rules[1]}"
# Nothing takes the way through the model on which a number is divided by 0.
way='/handshake[.]h:[0-9]+: never false' condition='if [(]in[.]by != 0[)] total [+]= asked / in[.]by; after'
ends 1 cover handshake FAULT=0 --hostile 5000 --report covered.json
says_like "^handshake, 1 shape: reached .*, 4 of 5 ways$"
says_like "$way: $condition [0-9]+ false, [0-9]+ true$"
[[ $(jq -c '.[0].ways' covered.json) == '{"reached":4,"all":5}' ]] || fails "the report has the ways"
if [[ $solvers ]]; then
  # A sweep of a clock or two does not take the others; stimuli do. Not each bit of the sum is decided.
  ends 1 cover handshake FAULT=0 --hostile 2
  says_like "/handshake[.]h:[0-9]+: never true: "
  ends 1 cover handshake FAULT=0 --hostile 2 --close --seconds 30 --stimuli reached
  says_like "^handshake, 1 shape: reached .*, 4 of 5 ways$"
  says_like "$way: unreachable, proved: $condition [0-9]+ false, [0-9]+ true$"
  grep -qE '^origin reaches .*handshake[.]h:[0-9]+ true: if [(]in[.]by != 0[)]' reached/*.stim ||
    fails "a stimulus says which way it takes"
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
