// The operations that a model may use, each as one text on machine integers and on another value
// type, whose results can then be compared.
#pragma once

#include <functional>
#include <vector>

#include "model/core/value.h"

namespace cosim::test {

// Several operations at once.
template <class V>
V wrapped(const V& v) {
  return select(v > V(255), v - V(511), select(v < V(-255), v + V(511), v));
}
template <class V>
V exchanged(const V& v) {
  return shift_left(v & V(0xf), 4) + (shift_right(v, 4) & V(0xf));
}
// A condition, and what becomes of it.
template <class V>
V in_place(const V& a, const V& b) {
  V kept = a == b;
  kept += 2, kept -= a, kept &= b | 3, kept |= 1, kept ^= a;
  return -kept + ~b;
}

template <class V>
struct Operation {
  const char* name;
  std::function<Word(Word, Word)> on_words;
  std::function<V(const V&, const V&)> on_values;
};

// Every operation that a model may use, with widths and shifts of several kinds.
template <class Value>
std::vector<Operation<Value>> operations() {
  // Of one body for any value type.
  const auto of = [](const char* name, auto body) {
    return Operation<Value>{name, [body](Word a, Word b) { return body(a, b); },
                            [body](const Value& a, const Value& b) { return body(a, b); }};
  };
#define OF(name, text) \
  of(name, []<class V>(const V& a, [[maybe_unused]] const V& b) -> V { return text; })
#define HOLDS(name, text) OF(name, flag<V>(static_cast<Condition<V>>(text)))
  return {
      OF("+", a + b),
      OF("-", a - b),
      OF("a + a", a + a),
      OF("+ of what was negated", a + select(b < V(5), V(0) - b, b)),
      OF("- of what was negated", a - select(b < V(5), V(0) - b, b)),
      OF("+ of two that were negated", (V(0) - a) + (V(0) - b)),
      OF("- of one that was negated twice", a - (V(0) - (V(0) - b))),
      OF("+ of what was negated and shifted",
         b + shift_left(select(a < b, V(0) - a, V(-1) - a), 2)),
      OF("8 a + low bits of b", shift_left(a, 3) + low_bits(b, 3)),
      OF("*", a * b),
      OF("* of a negative constant", a * V(-3)),
      OF("* beyond a word", multiply(multiply(a, V(Word{1} << 60)), b)),
      OF("+ beyond a word", add(shift_left(a, 60), shift_left(b, 60))),
      OF("- beyond a word", subtract(shift_left(a, 60), shift_left(b, 60))),
      OF("&", a & b),
      OF("|", a | b),
      OF("^", a ^ b),
      OF("& | ^ with constants", ((a & V(5)) | V(2)) ^ V(-4)),
      HOLDS("<", a < b),
      HOLDS(">", a > b),
      HOLDS("==", a == b),
      OF("low_bits", low_bits(a, 5)),
      OF("low_bits of few", low_bits(a, 40)),
      HOLDS("bit", bit(a, 3)),
      HOLDS("bit beyond", bit(a, 50)),
      OF("shift_left", shift_left(a, 7)),
      OF("shift_right", shift_right(a, 4)),
      OF("shift_right of all", shift_right(a, 30)),
      OF("shift_left by a value", shift_left(a, b)),
      OF("shift_left by few", shift_left(a, b & V(7))),
      OF("shift_left by many", shift_left(a, shift_left(b, 3))),
      OF("shift_right by a value", shift_right(a, b)),
      OF("shift_right by many", shift_right(a, shift_left(b, 3))),
      OF("a sum that wraps", wrapped(a + b)),
      OF("halves exchanged", exchanged(a)),
      // As machine integers have it too.
      OF("constants", (a + 1) - (2 - b) + select(a < 3, 4, a)),
      OF("conditions as numbers", (a < b) + bit(a, 2) + (bit(b, 0) & a)),
      OF("numbers as conditions", select(a & 1, b, select(b, a, 5))),
      OF("changed in place", in_place(a, b)),
      HOLDS("a choice of conditions", select(a < b, a == 1, bit(b, 1))),
      HOLDS("the other comparisons", (a != 3) & ((a <= b) | (b >= 7))),
      HOLDS("not, and, or", (a == b) | !((a < V(0)) & (b > V(3)))),
      HOLDS("not of one, exclusive or", !(a == b) & ((a < V(0)) ^ (b > V(3)))),
  };
#undef HOLDS
#undef OF
}

}  // namespace cosim::test
