// Golden model of handshake.v.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace handshake_model {

using namespace cosim;
using faulty::Params;

#define HANDSHAKE_INPUTS(FIELD)                  \
  FIELD(rst, 1, flag, "", "begin anew")          \
  FIELD(valid, 1, flag, "", "there is a number") \
  FIELD(data, 8, number, "", "the number")       \
  FIELD(by, 3, number, "", "what it is divided by")
#define HANDSHAKE_OUTPUTS(FIELD)                   \
  FIELD(ready, 1, flag, "", "the number is taken") \
  FIELD(sum, 32, number, "", "of all so far")
#define HANDSHAKE_STATE(FIELD)                     \
  FIELD(busy, 1, flag, "", "a number was seen")    \
  FIELD(asked, 8, number, "", "the last that was") \
  FIELD(total, 32, number, "", "of all so far")
COSIM_RECORDS(HANDSHAKE, Params);

/// a / b, by comparing: the divisors are few.
template <class V>
constexpr V quotient(V a, V b) {
  V q = V(0);
  V multiple = V(0);
  V left = V(0);
  for (int i = 7; i >= 0; --i) {
    left = shift_left(left, 1) + flag<V>(bit(a, i));
    const Condition<V> fits = !(left < b);
    multiple = select(fits, b, V(0));
    left = left - multiple;
    q = shift_left(q, 1) + flag<V>(fits);
  }
  return q;
}

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  using Flag = Condition<V>;
  const Flag reset = is_set(in.rst), busy = is_set(s.busy), valid = is_set(in.valid);
  Step<V> step;
  step.outputs = {s.busy, s.total};
  step.state.busy = flag<V>(!reset & !busy & valid);
  step.state.asked = select(reset, V(0), select(!busy & valid, in.data, s.asked));
  step.state.total =
      select(reset, V(0), select(busy, wrap(s.total + quotient(s.asked, in.by), 32), s.total));
  return step;
}

template <class V>
constexpr auto legal(const Params&, const State<V>& s, const Inputs<V>& in) {
  const Condition<V> busy = is_set(s.busy);
  return std::array{
      Stated<V>{"a number is held until ready", !busy | (is_set(in.valid) & (in.data == s.asked))},
      Stated<V>{"by is not 0", !(in.by == V(0))},
  };
}

template <class V>
constexpr Inputs<V> idle(const Params&, const State<V>& s) {
  return {V(0), s.busy, select(is_set(s.busy), s.asked, V(0)), V(1)};
}

struct Design : faulty::Design {
  COSIM_DESIGN(handshake_model);
  static constexpr const char* name = "handshake";
  static constexpr Inputs<Word> rest() { return {.by = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1, .by = 1}; }
};

}  // namespace handshake_model
