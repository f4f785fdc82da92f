# shellcheck shell=bash
# The step is refuted from a number above nine, which is never reached: that is asked before anything
# is said, of the model's registers and of what the RTL asserts. The fault is reached on clock 10, and
# what it takes replays.
if [[ $solvers ]]; then
  ends 0 prove decade FAULT=0 --failures decade_failures
  says_like "inductive step: .* proved from reset by "
  says_like "what the RTL asserts is so .* proved from reset by "
  says "4 of 4 claims proved, by cec and cadical, but 2 from reset by yosys-abc, checked"
  [[ ! -e decade_failures ]] || fails "a claim that is proved from reset leaves no folder"
  ends 1 prove decade FAULT=1 --failures decade_failures
  says "REFUTED from reset: clock 10, by "
  says "Assertion failed in TOP.decade"
  ends 1 replay decade_failures/decade-FAULT1-*/stimulus.stim
  # A regression asks so too.
  printf '{"format": 1, "name": "p", "tasks": [{"name": "claims", "prove": "decade"}]}' > decade.json
  ends 1 regress decade.json --folder decade_run
  says "FAILED: claims: decade FAULT=1"
  says "REFUTED from reset: clock 10"
  says_not "FAULT=0: inductive"
  refuted=(decade_run/failures/decade-FAULT1-*)
  ends 1 replay "${refuted[0]}"
fi
# So is a mutant that only a number above nine would show.
[[ ! $solvers ]] || ends 0 mutate decade FAULT=0 --mutants 100 --failures decade_failures
# Nor does anything take the way through the model on which the digit is above nine.
way='/decade[.]h:[0-9]+: never true' condition='if [(]digit_q > 9[)]; after [0-9]+ false, [0-9]+ true$'
ends 1 cover decade FAULT=0 --hostile 5000 --report covered.json
says_like "^decade, 1 configuration: reached .*, 3 of 4 ways$"
says_like "$way: $condition"
[[ $(jq -c '.[0].ways' covered.json) == '{"reached":3,"all":4}' ]] || fails "the report has the ways"
if [[ $solvers ]]; then
  # A clock takes one way; a stimulus takes each other one.
  ends 1 cover decade FAULT=0 --hostile 1
  says_like "^decade, 1 configuration: reached .*, 1 of 4 ways$"
  ends 0 cover decade FAULT=0 --hostile 1 --close --stimuli reached
  says_like "^decade, 1 configuration: reached .*, 3 of 4 ways$"
  says_like "$way: unreachable, proved: $condition"
  grep -qE '^origin reaches .*decade[.]h:[0-9]+ false: if [(]digit_q > 9[)]' reached/*.stim ||
    fails "a stimulus says which way it takes"
fi
