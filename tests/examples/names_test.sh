#!/usr/bin/env bash
# names_test.sh ROOT PROGRAM
#
# What a model may leave out is found by its name: one that is nearly such a name is refused, in a line
# that says where and what is meant, in struct Design and beside it, and in a header that is included.
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
refused invariant invarient "invarient(p, s, ...) means nothing: is invariant meant?" "$guarded"
refused cases casse "casse(p, s, ...) means nothing: is cases meant?"
refused invariant legall "legall(p, s, ...) means nothing: is legal meant?" "$guarded"
refused reset_inputs reset_input "reset_input in struct Design means nothing: is reset_inputs meant?"
refused reset_inputs clear "clear in struct Design means nothing: is reset_inputs meant?"
refused rest cleared "cleared in struct Design means nothing: is reset_state meant?"
refused rest clear_clocks "clear_clocks in struct Design means nothing: is reset_clocks meant?"
refused Checker Cheker "Cheker in struct Design means nothing: is Checker meant?"

# What only reads like one: a comment, a text, a member of another struct, a call, other arguments.
{
  sed '/^struct Design/,$d' "$uart"
  echo '// invarient(const Params& p, const State<V>& s)'
  echo 'inline const char* text = "legall(const Params& p, const State<V>& s)";'
  echo 'struct Other { static constexpr int reset_input = 1; };'
  echo 'constexpr int invarients(int p, int s) { return p + s; }'
  echo 'constexpr int twice(const Params& p, const State<Word>& s) { return legall(p, s); }'
  sed -n '/^struct Design/,$p' "$uart" | sed 's/^};/  static constexpr int own = 3;\n&/'
} > model.h
for header in "$root"/model/*/machine.h "$root"/examples/*/*.h "$root"/tests/*/designs/*.h model.h; do
  ends 0 names stamp "$root" "$header"
  grep -qF "$(basename "$header")" stamp.d || fails "ninja is told of $header"
done
echo "as it should be"
