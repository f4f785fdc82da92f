#!/usr/bin/env bash
# riscv_test.sh PROGRAM
#
# What a program of examples/riscv does beside its CTest tests: the cases of its transactions, in a
# verdict and in cover, how programs are drawn, and a failure as an assembler has it.
# Status: 0 so, 1 not.
program=$(realpath "$1")
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"

# An instruction or two meet few of the cases; a long sweep meets all of them.
ends 0 sweep core --hostile 40 --report few.json
says_like '^cases: [0-9]* of 56 happened$'
says_like '^never happened: [0-9]* more, which --report names$'
grep -q '"retired: a store behind a load": 0' few.json || fails "the report names what never happened"
ends 0 sweep core --hostile 200000 --report all.json --junit all.xml
says_like '^cases: ([0-9]+) of \1 happened$'
grep -q '"retired: a branch by 4": [1-9]' all.json || fails "the report counts a case"
grep -q 'tests="1" failures="0" errors="0"' all.xml || fails "a sweep is a test of JUnit"

ends 1 cover core --hostile 40
says "never happens: retired: a store behind a load"
if "${CXX:-c++}" --version | grep -q 'Free Software'; then  # GCC counts lines of the model, Clang does not
  says_like '/rv32i[.]h:[0-9]*: always the same: if [(]in[.]rst[)] [{]$'
  says_not 'never runs: pc = out.next_pc;'
fi
if command -v yosys > /dev/null; then
  ends 1 cover core --hostile 40 --close
  says 'core: a stream model, which knows no clock: nothing can be asked of it'
  says_like ', [0-9]* of these not asked$'
fi

ends 0 list --drawn
says_like '^step: 1[0-9]* transactions in '
says_like '^  step_op: addi 2[.][0-9] %, slti 2[.]'

# A program of 8 words, which leaves 2 as its signature and passes; with another byte its test 5 fails.
cp "$root/tests/fuzz/corpus/elf/32" passes.elf
cp passes.elf fails.elf
printf '\xb0' | dd of=fails.elf bs=1 seek=106 conv=notrunc status=none
ends 0 program core passes.elf --junit passes.xml
says_like '^core, passes.elf: 6 transactions, match$'
says_like '^transactions: step: 6 in; access: 8 out, 8 compared; retired: 6 out, 6 compared$'
says 'verdict: match'
grep -q 'tests="1" failures="0" errors="0"' passes.xml || fails "a program is a test of JUnit"
echo 00000002 > passes.elf.signature
ends 0 program core passes.elf --seed 2
echo 00000003 > passes.elf.signature
ends 1 program core fails.elf passes.elf --failures kept
says_like '^core, fails.elf: 6 transactions, MISMATCH$'
says 'RTL and model agree, but the checker reports: tohost: test 5 fails'
says 'RTL and model agree, but the checker reports: signature: word 0 is 00000002, and 00000003 in passes.elf.signature'
ends 2 program core
says 'FILE: is needed'
ends 2 program single passes.elf
says 'single: its model has no program(), which reads a file'
ends 2 program core /dev/null
says '/dev/null: is no file that can be read, or is empty'
