// The oracle of the linear machine as a step function, see model/core/walk.h: on which positions of
// a line each axis steps, from their numbers alone.
#pragma once

#include "model/core/walk.h"
#include "model/linear/drive.h"

namespace cosim::linear {

// clang-format off
/// What is due of a line, beside its words.
#define LINEAR_DUE(FIELD)                                                                          \
  FIELD(words, p.n + 1, number, "", "how many")

#define LINEAR_WALKED(FIELD)                                                                       \
  FIELD(words, p.n + 1, number, "", "so far")
// clang-format on

COSIM_RECORD(Due, LINEAR_DUE, Params);
COSIM_RECORD(Walked, LINEAR_WALKED, Params);
template <class V>
using Walk = WalkOf<Task, Due, Walked, Driven, V>;

Due<Word> due_of(const Params& p, const Job& job);
inline Walked<Word> begun(const Params&, const Job&) { return {}; }

/// Whether the minor axis steps on position q of a code, 1 <= q <= 2^m: bit a_i where q is
/// 2^(i-1) * odd, none where i > m.
template <class V>
constexpr Condition<V> steps_at(const Params& p, const V& code, const V& q) {
  Condition<V> steps = false, is_even = true;
  for (int i = 1; i <= p.m; ++i) {
    steps = steps | (is_even & bit(q, i - 1) & bit(code, p.m - i));
    is_even = is_even & !bit(q, i - 1);
  }
  return steps;
}

/// Wrong are the words on the outputs, or the number of them.
template <class V>
constexpr Verdict<Walked, V> walked(const Params& p, const Walk<V>& line, const Outputs<V>& seen,
                                    Condition<V> over) {
  const auto& [t, due, walked, driven] = line;
  const V words = walked.words;
  const V whole = shift_right(t.major, p.gamma()), rest = low_bits(t.major, p.gamma());
  Condition<V> wrong = false;
  for (int q = 1; q <= p.word(); ++q) {
    const Condition<V> live = (words < whole) | ((words == whole) & !(rest < V(q)));
    const Condition<V> minor = live & steps_at(p, t.code, shift_left(words, p.gamma()) + V(q));
    wrong =
        wrong | (live ^ bit(seen.major, p.word() - q)) | (minor ^ bit(seen.minor, p.word() - q));
  }
  const Condition<V> strobe = is_set(seen.strobe);
  const V now = select(strobe, words + V(1), words);
  return {{now},
          Condition<V>((strobe & wrong) | (over & !is_set(t.counted) & !(now == due.words)))};
}

}  // namespace cosim::linear
