# shellcheck shell=bash
# Jobs on a machine that no reset brings to one state: in lanes there is the same to see as one case at
# a time, of a match, of a difference and of what only the check finds wrong.
ends 0 job serial FAULT=0 'a=3 b=250; early=-3 a=49 b=249'
says_like 'left out.*shifted'
ends 1 job serial FAULT=0 'early=4 a=49 b=250' --failures none
says "early=4 a=49 b=250, clock 16: checked due=0, and then busy=0 product=12250"
if [[ $solvers ]]; then
  # both CASES TEXT: that is said of so many, and the reports are the same.
  both() {
    local lanes
    for lanes in 0 64; do
      ends 1 sweep serial --random "$1" --lanes "$lanes" --report "$lanes.json"
      says_like "$2"
    done
    cmp -s 0.json 64.json || fails "$1 cases are the same in lanes: $(diff 0.json 64.json | head)"
  }
  both 200 '^serial FAULT=1, case [1-9][0-9]*: early'
  both 20000 'a=49 b=25[0-5], clock [0-9]+: checked due=0, and then'
fi
