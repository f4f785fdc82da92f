# shellcheck shell=bash
# Each reset acts at once and on its own registers alone.
# The fault, at count 21 on clock 21, shows on clock 22, unless a lap begins on that.
stimulus 'laps FAULT=1' 'rst_n lap en' '0-20 1 0 1' '21-22 1 0 0'
ends 1 replay a.stim
says "first difference: clock 22, part"
stimulus 'laps FAULT=1' 'rst_n lap en' '0-20 1 0 1' '21 1 0 0' '22 1 1 0' '23 1 0 1'
ends 0 replay a.stim
stimulus 'laps FAULT=1' 'rst_n lap en' '0-20 1 0 1' '21 1 0 0' '22 0 0 0'
ends 1 replay a.stim
stimulus 'laps FAULT=0' 'rst_n lap en' '0-9 1 0 1' '10 0 0 1' '11-15 1 0 1' '16-17 1 1 1' '18 0 1 1' \
  '19-20 1 0 1'
ends 0 replay a.stim
