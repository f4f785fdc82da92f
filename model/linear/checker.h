// The check of a line, see model/core/job.h: on which positions each axis steps, from their numbers
// alone.
#pragma once

#include <bit>

#include "model/linear/drive.h"

namespace cosim::linear {

// clang-format off
#define LINEAR_CHECKER(FIELD)                                                                      \
  FIELD(due,   p.n + 1, number, "", "words of the line")                                           \
  FIELD(words, p.n + 1, number, "", "so far")
// clang-format on

COSIM_RECORD(Checker, LINEAR_CHECKER, Params);

Checker<Word> checker_of(const Params& p, const Job& job);

/// Whether the minor axis steps on position q of a code, 1 <= q <= 2^m: bit a_i where q is
/// 2^(i-1) * odd, none where i > m. The lowest `zeros` bits of q are known to be 0.
template <class V>
constexpr Condition<V> steps_at(const Params& p, const V& code, const V& q, int zeros) {
  Condition<V> steps = false, is_even = true;
  for (int i = zeros + 1; i <= p.m; ++i) {
    steps = steps | (is_even & bit(q, i - 1) & bit(code, p.m - i));
    is_even = is_even & !bit(q, i - 1);
  }
  return steps;
}

/// Wrong are the words on the outputs, or the number of them.
template <class V>
constexpr Verdict<Checker, V> checked(const Params& p, const Task<V>& t, const Driver<V>&,
                                      const Checker<V>& c, const Outputs<V>& seen,
                                      Condition<V> over) {
  const V words = c.words;
  const V whole = shift_right(t.major, p.gamma()), rest = low_bits(t.major, p.gamma());
  const Condition<V> is_whole = words < whole, is_last = words == whole;
  Condition<V> wrong = false;
  for (int q = 1; q <= p.word(); ++q) {
    const Condition<V> live = is_whole | (is_last & !(rest < V(q)));
    // But for the last position of a word its number is 2^(i-1) * odd where q is.
    const int zeros = std::countr_zero(static_cast<unsigned>(q));
    const Condition<V> minor =
        live & (q < p.word() ? Condition<V>(bit(t.code, p.m - 1 - zeros))
                             : steps_at(p, t.code, shift_left(words + V(1), p.gamma()), zeros));
    wrong =
        wrong | (live ^ bit(seen.major, p.word() - q)) | (minor ^ bit(seen.minor, p.word() - q));
  }
  const Condition<V> strobe = is_set(seen.strobe);
  const V now = select(strobe, words + V(1), words);
  return {{c.due, now},
          Condition<V>((strobe & wrong) | (over & !is_set(t.counted) & !(now == c.due)))};
}

}  // namespace cosim::linear
