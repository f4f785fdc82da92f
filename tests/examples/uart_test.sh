#!/usr/bin/env bash
# uart_test.sh PROGRAM
#
# What a program of somebody's own does beside its CTest tests, on that of examples/uart: its name in
# what it says, jobs, waves, lint, mutants, and bad input of each.
# Status: 0 so, 1 not.
program=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"
# refuses LINE WORDS...: it ends with 2, and that is all that it says.
refuses() {
  local line="uart_cosim: $1"
  shift
  ends 2 "$@"
  [[ $(< said) == "$line" ]] || fails "'$*' says: $line"
}

# Its own name.
refuses "'uart D=5' is not built; see uart_cosim list" lint uart D=5
refuses "'nothing' is not built; see uart_cosim list" prove nothing
ends 0 --help
says "uart_cosim COMMAND --help"
ends 0 sweep uart --help
says "Example: uart_cosim sweep uart"

# Jobs: the value that a field has by itself is the simplest; a job has a wave.
ends 0 job uart D=16 'byte=65; idle=3 byte=77' --wave job.fst
says "uart D=16: idle=0 byte=65; idle=3 byte=77"
says "verdict: match"
[[ -s job.fst && -s job.gtkw ]] || fails "job draws"
refuses "DESIGN: is needed" job
refuses "idle: '41' is no number from 0 to 40" job uart idle=41
refuses "byte: 'x' is no number from 0 to 255" job uart byte=x
refuses "byte: is given more than once" job uart byte=1 byte=2
refuses "'word=1' is no field of a job and its value; there are idle, byte" job uart word=1
refuses "uart_rx: declares no jobs" job uart_rx
refuses "sweep: one of --random and --hostile is needed, none is given" sweep uart
refuses "sweep: one of --random and --hostile is needed, more are given" \
  sweep uart --random 5 --hostile 5

# A regression is a stimulus; so is what a wave is drawn of.
printf '%s\n' 'cosim stimulus 1' 'machine uart D=4' 'power-up 1' 'clock rst_n valid data' \
  '0-9 1 0 00000000' end > quiet.stim
ends 0 wave quiet.stim --out quiet.fst
[[ -s quiet.fst && -s quiet.gtkw ]] || fails "wave draws a stimulus"
ends 0 wave uart D=16 --hostile 20 --out hostile.fst
says "uart D=16: hostile clocks, seed 1"
refuses "there is no display; --shot FILE.png and --out FILE.fst draw without one" wave uart
refuses "none.stim: no such file" wave none.stim
refuses "failures: no failure is kept there; name a stimulus or a design" wave --out it.fst
refuses "--hostile: needs a design, not a file" wave quiet.stim --hostile 5 --out it.fst
refuses "--hostile: '0' is not a whole number from 1 to 2000000" wave uart --hostile 0 --out it.fst

ends 0 lint uart D=4
says "clean"

# Without a proof what is not killed survives: with its cell and its line, and with a folder.
if command -v yosys > /dev/null; then
  ends 1 mutate "uart D=4" --mutants 60 --unproved --list --failures failures --report all.json
  read -r killed survived < <(sed -nE \
    's/^uart D=4: 60 mutants: ([0-9]+) killed, 0 proved equal, ([0-9]+) survived$/\1 \2/p' said)
  ((survived > 0 && killed + survived == 60)) || fails "each is killed or survives, and some do"
  grep -qE '^survived: -mode .* -cell .* -src .*uart(_divider)?\.v:[0-9]+' said ||
    fails "a survivor has its cell and its line"
  kept=(failures/uart-D4-mutant-*/report.txt)
  ((${#kept[@]} == survived)) || fails "each survivor is kept"
  grep -q 'uart_cosim prove uart D=4 --mutants' "${kept[0]}" || fails "how to prove it"
  (($(grep -c '"end": "killed"' all.json) == killed)) || fails "the report has them"
  (($(grep -c ': killed by ' said) == killed)) || fails "--list has them"
fi
refuses "--mutants: '0' is not a whole number from 1 to 65535" mutate uart --mutants 0
refuses "'uart D=5' is not built; see uart_cosim list" mutate uart D=5
echo "as it should be"
