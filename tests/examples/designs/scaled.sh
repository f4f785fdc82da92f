# shellcheck shell=bash
# From a state: what hangs on the registers follows them.
printf 'cosim stimulus 1\nmachine scaled FAULT=0 W=6\nstate total=37\nclock rst d\n0-3 0 5\nend\n' > a.stim
ends 0 replay a.stim
