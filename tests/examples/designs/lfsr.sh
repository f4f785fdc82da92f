# shellcheck shell=bash
# It begins at its initial value, and its parameters reached the RTL, the model and the proof.
printf 'cosim stimulus 1\nmachine lfsr FAULT=0 TAPS=184 MODE=FILL\nclock en\n0-9 1\n10-11 0\nend\n' > a.stim
ends 0 replay a.stim --report report.json
grep -q '"MODE": "FILL"' report.json || fails "the report has the text of MODE"
printf 'cosim stimulus 1\nmachine lfsr FAULT=0 TAPS=184 MODE=FILL\nstate bits=7\nclock en\n0-9 1\nend\n' > a.stim
ends 0 replay a.stim
[[ ! $solvers ]] || { ends 0 prove lfsr FAULT=0 && says "they begin the same"; }
