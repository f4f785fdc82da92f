# shellcheck shell=bash
# A reset that does not wait for the clock: on its first clock all is reset before the edge.
# The fault, at count 12 on clock 9, shows on clock 10, unless that resets.
stimulus 'gray FAULT=1' 'rst_n en' '0-10 1 1' '11 0 1'
ends 1 replay a.stim
says "first difference: clock 10, odd"
stimulus 'gray FAULT=1' 'rst_n en' '0-9 1 1' '10 0 1' '11-12 1 1'
ends 0 replay a.stim
stimulus 'gray FAULT=0' 'rst_n en' '0-10 1 1' '11 0 1' '12-13 1 0'
ends 0 replay a.stim
# From a state the reset acts at once, too.
printf 'cosim stimulus 1\nmachine gray FAULT=0\nstate count=9 odd=1 all=7\nclock rst_n en\n0 0 1\n1-3 1 1\n4 0 0\nend\n' > a.stim
ends 0 replay a.stim
ends 0 lint gray FAULT=0
if [[ $solvers ]]; then
  ends 0 prove gray FAULT=0
  says "a reset makes them the same, but for all"
fi
