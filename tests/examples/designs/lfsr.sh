# shellcheck shell=bash
# It begins at its initial value, and its parameters reached the RTL, the model and the proof.
stimulus 'lfsr FAULT=0 TAPS=184 MODE=FILL' en '0-9 1' '10-11 0'
ends 0 replay a.stim --report report.json
grep -q '"MODE": "FILL"' report.json || fails "the report has the text of MODE"
printf 'cosim stimulus 1\nmachine lfsr FAULT=0 TAPS=184 MODE=FILL\nstate bits=7\nclock en\n0-9 1\nend\n' > a.stim
ends 0 replay a.stim
if [[ $solvers ]]; then
  ends 0 prove lfsr FAULT=0
  says "they begin the same"
  # A regression leaves what refutes a claim as a failure that replays.
  printf '{"format": 1, "name": "p", "tasks": [{"name": "claims", "prove": "lfsr"}]}' > plan.json
  ends 1 regress plan.json --folder run
  says "FAILED: claims: lfsr FAULT=1"
  refuted=(run/failures/lfsr-FAULT1-*)
  [[ -d ${refuted[0]} ]] || fails "a refuted claim leaves a folder"
  ends 1 replay "${refuted[0]}"
fi
# A text is a text for the linters too: with another value the RTL does not elaborate.
ends 1 lint lfsr FAULT=0 # Verilator has words about widths
says_like "iverilog -Wall +clean"
says_not no_such_mode
