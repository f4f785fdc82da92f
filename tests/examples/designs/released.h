// Golden model of released.v.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace released_model {

using namespace cosim;
using faulty::Params;

#define RELEASED_INPUTS(FIELD)                    \
  FIELD(rst_n, 1, flag, "", "0: reset, at once")  \
  FIELD(stop, 1, flag, "", "reset, at the clock") \
  FIELD(en, 1, flag, "", "count this clock")
#define RELEASED_OUTPUTS(FIELD) FIELD(q, 3, number, "", "the count")
#define RELEASED_STATE(FIELD)                  \
  FIELD(first, 1, flag, "", "no reset so far") \
  FIELD(ready, 1, flag, "", "it may count")    \
  FIELD(count, 3, number, "", "the count")
COSIM_RECORDS(RELEASED, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  const V ready = select(is_set(in.stop), V(0), s.first);
  // On the edge on which it ends the reset still holds.
  const V count = select(is_set(s.ready), wrap(s.count + in.en, 3), V(5));
  return {{V(1), ready, count}, {s.count}};
}

template <class V>
constexpr State<V> reset(const Params&, State<V> s, const Inputs<V>& in) {
  s.first = select(is_set(in.rst_n), s.first, V(0));
  s.ready = select(is_set(in.rst_n), s.ready, V(0));
  s.count = select(is_set(s.ready), s.count, V(5));
  return s;
}

struct Design : faulty::Design {
  COSIM_DESIGN(released_model);
  static constexpr const char* name = "released";
  static constexpr Inputs<Word> rest() { return {.rst_n = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {}; }
  template <class V>
  static constexpr State<V> reset_state() {
    return {V(0), V(0), V(5)};
  }
};

}  // namespace released_model
