#!/usr/bin/env bash
# names_test.sh ROOT PROGRAM
#
# What a model may leave out is found by its name: one that is nearly such a name is refused, in a line
# that says where and what is meant, also in a header that is included.
# Names of a model's own are none of it. Status: 0 so, 1 not.
root=$(realpath "$1") program=$2
source "$(dirname "${BASH_SOURCE[0]}")/../support/program.sh"
uart=$root/examples/uart/uart.h
# refused FROM TO LINE [MODEL]: a model, the uart's, with one name for another, included by the header that
# is given.
refused() {
  sed "s/\b$1\b/$2/" "${4-$uart}" > part.h
  grep -q "\b$2\b" part.h || fails "there is no $1 in ${4-$uart}"
  echo '#include "part.h"' > model.h
  rm -f stamp
  ends 2 names stamp "$root" model.h
  [[ $(< said) == "$PWD"/part.h:*": $3" ]] || fails "it says: $3"
  [[ ! -e stamp ]] || fails "it leaves no stamp"
}
guarded=$root/tests/stream/designs/guarded.h
refused invariant invarient "invarient in struct Guarded means nothing: is invariant meant?" "$guarded"
refused cases casse "casse in struct Uart means nothing: is cases meant?"
refused cases legall "legall in struct Uart means nothing: is legal meant?"
refused reset resett "resett in struct Uart means nothing: is reset meant?"
refused Checker Cheker "Cheker in struct Uart means nothing: is Checker meant?"
refused out ot "ot in struct Guarded means nothing: is out meant?" "$guarded"
fir=$root/examples/fir/fir.h
refused run Run "Run in struct Fir means nothing: is run meant?" "$fir"
refused pins pin_s "pin_s in struct Fir means nothing: is pins meant?" "$fir"
apb=$root/examples/apb/apb.h
refused Drives Drive "Drive in struct Master means nothing: is Drives meant?" "$apb"
refused took tok "tok in struct Master means nothing: is took meant?" "$apb"

# What only reads like one: a comment, a text, a register, another word, a member of another struct, a call.
{
  sed '/  UInt<4> left/,$d' "$uart"
  echo '// auto casse(const In&) const'
  echo '  Bit computed() const { return 1; }'
  echo '  UInt<4> cases_ = 0, rest_ = 0; Bit legall = 0;'
  echo '  const char* text() const { return "legall(const In&)"; }'
  echo '  struct Other { static constexpr int reset_input = 1; Bit casse() { return legall(1); } };'
  sed -n '/  UInt<4> left/,$p' "$uart"
} > model.h
for header in "$root"/model/{circular/circular,dda/dda,linear/linear}.h "$root"/examples/*/*.h "$root"/tests/*/designs/*.h model.h; do
  ends 0 names stamp "$root" "$header"
  grep -qF "$(basename "$header")" stamp.d || fails "ninja is told of $header"
done
# What CMake refuses of a model, before a compiler says it in 90 lines: LINE MODEL [WORDS].
configured() {
  printf '%s\n' 'set(VERILATOR_ROOT x)' "include($root/tb/package/design.cmake)" \
    "cosim_add_design(queue SOURCES model.h MODEL other.h ${3-})" > add.cmake
  printf '%s\n' "$2" > other.h
  if cmake -P add.cmake > said 2>&1; then fails "a model is refused: $2"; fi
  says_like "$1"
}
reads='#include <cosim/model.h>'
configured 'MODEL: no header has #include <cosim/model.h> or' '#include "model.h"'
configured 'MODEL: has no struct Queue; STRUCT names' "$reads"$'\nstruct QUEUE {'
configured 'Queue is a template: SHAPES gives' "$reads"$'\ntemplate <int W>\nstruct Queue {'
configured 'Queue is no template, but SHAPES gives' "$reads"$'\nstruct Queue {' 'SHAPES "W=8"'
printf '%s\n' "include($root/tb/package/design.cmake)" 'cosim_add_tests(queue)' > add.cmake
if cmake -P add.cmake > said 2>&1; then fails "tests of no program are refused"; fi
says_like 'cosim_add_tests\(queue\): no program of this name'
echo "as it should be"
