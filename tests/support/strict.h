// A value type that offers what model/core/value.h says a model may use and nothing else. Its
// comparisons give a class of their own that does not turn into bool, so a model with an `if` or
// an && on a value, with a division or an index by a value, does not compile on it. A sum,
// difference or product that does not fit is an std::overflow_error.
#pragma once

#include <stdexcept>

#include "model/core/value.h"

namespace cosim::test {

struct Truth {
  bool holds = false;
  friend constexpr Truth operator!(Truth a) { return {!a.holds}; }
  friend constexpr Truth operator&(Truth a, Truth b) { return {a.holds && b.holds}; }
  friend constexpr Truth operator|(Truth a, Truth b) { return {a.holds || b.holds}; }
  friend constexpr Truth operator^(Truth a, Truth b) { return {a.holds != b.holds}; }
};

struct Strict {
  Word word = 0;
  constexpr Strict() = default;
  constexpr explicit Strict(Word w) : word(w) {}

  friend constexpr Strict operator+(Strict a, Strict b) {
    Strict sum;
    return __builtin_add_overflow(a.word, b.word, &sum.word) ? too_large() : sum;
  }
  friend constexpr Strict operator-(Strict a, Strict b) {
    Strict difference;
    return __builtin_sub_overflow(a.word, b.word, &difference.word) ? too_large() : difference;
  }
  friend constexpr Strict operator*(Strict a, Strict b) {
    Strict product;
    return __builtin_mul_overflow(a.word, b.word, &product.word) ? too_large() : product;
  }
  friend constexpr Strict operator&(Strict a, Strict b) { return Strict(a.word & b.word); }
  friend constexpr Strict operator|(Strict a, Strict b) { return Strict(a.word | b.word); }
  friend constexpr Strict operator^(Strict a, Strict b) { return Strict(a.word ^ b.word); }
  friend constexpr Truth operator<(Strict a, Strict b) { return {a.word < b.word}; }
  friend constexpr Truth operator>(Strict a, Strict b) { return {a.word > b.word}; }
  friend constexpr Truth operator==(Strict a, Strict b) { return {a.word == b.word}; }

 private:
  [[noreturn]] static Strict too_large() { throw std::overflow_error("does not fit into a Word"); }
};

constexpr Strict low_bits(Strict v, int width) { return Strict(cosim::low_bits(v.word, width)); }
constexpr Truth bit(Strict v, int i) { return {cosim::bit(v.word, i)}; }
constexpr Strict shift_left(Strict v, int n) { return Strict(cosim::shift_left(v.word, n)); }
constexpr Strict shift_right(Strict v, int n) { return Strict(cosim::shift_right(v.word, n)); }
constexpr Strict shift_left(Strict v, Strict n) {
  return Strict(cosim::shift_left(v.word, n.word));
}
constexpr Strict shift_right(Strict v, Strict n) {
  return Strict(cosim::shift_right(v.word, n.word));
}
constexpr Strict add(Strict a, Strict b) { return Strict(cosim::add(a.word, b.word)); }
constexpr Strict subtract(Strict a, Strict b) { return Strict(cosim::subtract(a.word, b.word)); }
constexpr Strict multiply(Strict a, Strict b) { return Strict(cosim::multiply(a.word, b.word)); }
constexpr Strict select(Truth c, Strict a, Strict b) { return c.holds ? a : b; }

}  // namespace cosim::test
