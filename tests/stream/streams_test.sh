#!/usr/bin/env bash
# streams_test.sh --built FOLDER | --program PROGRAM [NAME...]
#
# Installs the harness that was built in FOLDER and builds the designs of designs/ that are named, all
# where none is, against it. What is as it should be passes; each planted fault is found, said by its
# name, and shrunk to so few transactions; its stimulus shows it again, and draws it. PROGRAM: one that
# was built already. Status: 0 so, 1 not.
here=$(cd "$(dirname "$0")" && pwd)
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"
program_of streams "$here/designs" "$@"
((${#chosen[@]} > 0)) || chosen=(loses doubles hangs slow wrong bends asks idles sha256 word pairs divider
  credits blocks packets serial stack keeps crosses lookup asserts asserted guarded)

# found DESIGN KIND MOST: the fault is found, of that kind, and its smallest stimulus has at most MOST
# transactions, and shows it again.
found() {
  local design=$1 kind=$2 most=$3 smallest rows page
  rm -rf kept
  ends 1 sweep "$design" --hostile 1000000 --failures kept
  says_like "^$kind"
  smallest=(kept/*/smallest.stim)
  grep -q '^origin.*case [0-9]*: 1000 clocks of transactions, seed 1' "${smallest[0]}" ||
    fails "$design: a stimulus says where it comes from"
  ends 1 replay "${smallest[0]}" --wave again.fst --html again.html
  [[ -s again.fst && -s again.gtkw ]] || fails "the wave is drawn"
  grep -qE "^<pre class=\"first\">$kind" kept/*/report.html || fails "the page says what is wrong"
  for page in kept/*/report.html again.html; do
    grep -qF '>first difference</text>' "$page" || fails "$page shows where"
  done
  rows=$(sed -n 's/^smallest stimulus that still fails: \([0-9]*\) transactions\?, .*/\1/p' \
    kept/*/report.txt)
  cp "${smallest[0]}" "$design.stim"
  if ((rows > most)); then
    cat "$design.stim"
    fails "$design: $rows transactions, at most $most"
  fi
  echo "$design: $kind, shrunk to $rows"
}

# both DESIGN KIND MOST: its fault is found, and without it nothing is.
both() {
  found "$@"
  ends 1 sweep "$1" --hostile 20000 --failures kept
  says_like "^$1 FAULT=0, random transactions with random stalls: [0-9]* clocks"
}

# no_lanes DESIGN: a design with streams is refused in lanes in one line.
no_lanes() {
  ends 2 sweep "$1" --hostile 1000 --lanes 512
  says_like "^streams: $1.*: does not run in lanes: it has a stream model, which knows no clock$"
  (($(wc -l < said) == 1)) || fails "lanes of $1 are refused in one line"
}

# The faults of the filter. A value is lost or doubled only where somebody waits.
try_loses() {
  found loses lost 2
  grep -qE '^0 .* ([1-9][0-9]* +[01]|0 +1)$' loses.stim || fails "what loses a value keeps the stall that shows it"
  no_lanes loses
  # One clock is too few for anything to come out.
  ends 2 sweep loses --hostile 1
  says_like '^verdict: nothing compared$'
  says_like '^streams: loses .*: nothing was compared: x: [01] in; y: 0 out, 0 compared; '
  ends 0 sweep loses --hostile 1 --allow-nothing-compared
  says_like '^never compared: y, '
  says_like '^verdict: nothing compared$'
}
# Where all are taken late all are doubled, which has no name.
try_doubles() { found doubles '(doubled|another value): y number' 2; }
try_hangs() { found hangs hung 2; }
# Every fourth clock: a transaction before it shrinks to a stall.
try_slow() { found slow late 1; }
try_wrong() { found wrong 'another value' 5; }
# Right as long as nobody waits: the stall that shows it is left.
try_bends() {
  found bends 'another value: y number 0' 1
  grep -qE '^0 .* ([1-9][0-9]* +[01]|0 +1)$' bends.stim || fails "the stall that gives another result is kept"
}
# Nothing is wrong but with one whose ready waits for valid: that is what is left.
# hangs_where_it_waits DESIGN SMALLEST: so it is, and that is said of the smallest.
hangs_where_it_waits() {
  found "$1" 'hung: x number . is not taken, y_ready waits for y_valid, ' 1
  says_like "^hung: $2, y_ready waits for y_valid, "
  grep -qE '^0 .* 0 +1$' "$1.stim" || fails "who takes waits, and does not stall"
}
try_asks() { hangs_where_it_waits asks 'y number 0 does not come'; }
try_idles() { hangs_where_it_waits idles 'x number 0 is not taken'; }

# Blocks of 512 bits, 66 clocks each, by both of its models.
try_sha256() {
  ends 0 sweep sha256 --hostile 100000
  says_like '^sha256, any value on any pin on any clock: 100000 clocks'
  says_like '^sha256 streams, random transactions with random stalls: 1[0-9]* clocks'
  says_like '^compared: 32 registers and 6 outputs of sha256 on each'
  says_like '^compared: values and order of all that comes out at digest of sha256 streams on each'
}
try_word() { found word 'another value: digest' 1; }

# Every kind of interface.
try_pairs() { both pairs '(another value|taken back): parts' 1; }
# A wire of several words, a tied one too; and a field at a port of its own name.
try_blocks() { both blocks 'another value: digest' 1; }
try_serial() { both serial 'another value: out' 1; }
# What came last goes first, where two wait.
try_stack() { both stack 'reordered: y number 0 comes after number 1' 2; }
# What no reset reaches is what it was at power-up, whatever ran before: the case shows it again by itself.
try_keeps() { both keeps 'another value: y number 0' 1; }
# What means nothing is not compared, and counts as a case that must happen.
try_lookup() {
  both lookup 'another value: y number' 1
  says 'cases: 1 of 1 happened'
  grep -q '^0  *1  *0  *9 ' lookup.stim || fails "the key is that of the fault"
}
# Where the writer is faster, which words are lost; the wave has both clocks.
try_crosses() {
  both crosses '(lost|another value): y number [0-9]*' 8
  grep -q '>slow<' kept/*/report.html || fails "the page shows on which clocks it has its edge"
  # In the nets each of its clocks says whether it takes its edge.
  if command -v yosys > /dev/null; then
    ends 1 mutate crosses FAULT=0 --mutants 40
    says_like '^crosses FAULT=0: 40 mutants: 3[0-9] killed, 0 proved equal, [1-9] survived$'
  fi
}
try_credits() { both credits 'credit: out number [0-9]* comes without any' 6; }
try_packets() { both packets 'another value: sum' 3; }
try_divider() {
  both divider 'another value: given' 1
  says_like '^assumed of the inputs: asked: the divisor is not 0$'
  ends 2 prove divider
  says 'divider: a stream model, which knows no clock: nothing can be proved of it'
  sed 's/^0 .*/0  1  0  7  0/' divider.stim > zero.stim
  ends 2 replay zero.stim
  says_like 'a transaction that breaks an assumption: the divisor is not 0'
  sed 's/^transaction /clock /' divider.stim > clocks.stim
  ends 2 replay clocks.stim
  says_like 'is not origin, power-up, state or transaction'
  ends 0 cover divider FAULT=0 --hostile 20000
  says_like '^divider, 1 configuration: reached [0-9]* of [0-9]* lines, '
  # Of streams alone a mutant is killed or not, and never equal. Of 40 one is left: that done holds its
  # 0 while the divider works is never needed, for it has been 0 since the start.
  if command -v yosys > /dev/null; then
    ends 1 mutate divider FAULT=0 --mutants 40
    says 'divider FAULT=0: a stream model, which knows no clock: no mutant can be proved equal'
    says_like '^divider FAULT=0: 40 mutants: 3[0-9] killed, 0 proved equal, [1-3] survived$'
    # A survivor's report has the lines that declare them.
    sed -n 's/^  \(divider FAULT=0: .* -- \)REASON$/\1it holds 0 already/p' \
      failures/divider-*mutant*/report.txt > equivalent
    ends 0 mutate divider FAULT=0 --mutants 40 --equivalent equivalent
    says_like '^declared equivalent: divider FAULT=0: .*: it holds 0 already$'
  else
    echo 'no yosys: no mutants'
  fi
}

# What the RTL says of itself, of streams and in lockstep, with its file and line.
try_asserts() { both asserts 'the RTL says: .*asserts.v:[0-9]*: .*[12][0-9]* is more than 100$' 1; }
try_asserted() {
  ends 1 sweep asserted --hostile 20000 --failures asserted
  says_like '^asserted FAULT=0, .*: 20000 clocks'
  says_like '^the RTL says: .*asserted.sv:11: .*count is 10$'
  # Ten clocks up to ten, one to say so.
  grep -q '^smallest stimulus that still fails: 11 clocks' asserted/*/report.txt ||
    fails "it is shrunk"
  grep -q '"finding": "the RTL says' asserted/*/report.json || fails "the report has it"
  ends 1 replay asserted/*/smallest.stim
  says_like '^the RTL says: .*asserted.sv:11: '
}
# With a model of every clock beside that of streams: what is the same is proved to be, what the RTL
# asserts too, and a mutant is one or the other.
try_guarded() {
  if command -v yosys > /dev/null; then
    ends 0 prove guarded FAULT=0
    says_like 'what the RTL asserts is so .* proved from reset by '
    says_like '^4 of 4 claims proved, by cec and cadical, but 1 from reset'
    ends 1 prove guarded FAULT=1 --failures guarded
    says_like 'what the RTL asserts is so .* REFUTED'
    says_like '^3 of 4 claims proved, by cec and cadical, in'
    ends 1 replay guarded/*/smallest.stim
    says_like '^the RTL says: .*guarded.sv:21: '
    ends 0 mutate guarded FAULT=0 --mutants 100
    says_like '^guarded FAULT=0: [0-9]* mutants: [0-9]* killed, [1-9][0-9]* proved equal, 0 survived$'
    # Those that are the same are no more than not killed, where nothing proves it.
    ends 1 mutate guarded FAULT=0 --mutants 100 --unproved
    says_like '^guarded FAULT=0: [0-9]* mutants: [0-9]* killed, 0 proved equal, [1-9][0-9]* survived$'
  else
    echo 'no yosys: nothing is proved'
  fi
  ends 1 sweep guarded --hostile 20000 --failures kept
  says_like '^guarded FAULT=0, any value on any pin on any clock: 20000 clocks'
  says_like '^guarded FAULT=0 streams, random transactions with random stalls: 200[0-9]* clocks'
  says_like '^the RTL says: .*guarded.sv:21: '
  # It has a step beside its streams, which would run in lanes.
  ends 2 sweep guarded --hostile 1000 --lanes 512
  says_like '^streams: guarded FAULT=0: does not run in lanes: its RTL checks itself, with an assertion or [$]error$'
}

for name in "${chosen[@]}"; do
  "try_$name"
  echo "$name: as it should be"
done
