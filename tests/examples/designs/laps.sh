# shellcheck shell=bash
# Each reset acts at once and on its own registers alone. stimulus FAULT ROW...: "rst_n lap en".
stimulus() {
  printf 'cosim stimulus 1\nmachine laps FAULT=%s\nclock rst_n lap en\n' "$1" > a.stim
  printf '%s\n' "${@:2}" end >> a.stim
}
# The fault, at count 21 on clock 21, shows on clock 22, unless a lap begins on that.
stimulus 1 '0-20 1 0 1' '21-22 1 0 0'
ends 1 replay a.stim
says "first difference: clock 22, part"
stimulus 1 '0-20 1 0 1' '21 1 0 0' '22 1 1 0' '23 1 0 1'
ends 0 replay a.stim
stimulus 1 '0-20 1 0 1' '21 1 0 0' '22 0 0 0'
ends 1 replay a.stim
stimulus 0 '0-9 1 0 1' '10 0 0 1' '11-15 1 0 1' '16-17 1 1 1' '18 0 1 1' '19-20 1 0 1'
ends 0 replay a.stim
