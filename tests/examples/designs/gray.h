// Golden model of gray.v.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace gray_model {

using namespace cosim;
using faulty::Params;

#define GRAY_INPUTS(FIELD)                            \
  FIELD(rst_n, 1, flag, "", "0: begin anew, at once") \
  FIELD(en, 1, flag, "", "count this clock")
#define GRAY_OUTPUTS(FIELD)                             \
  FIELD(code, 4, bits, "", "the count in Gray code")    \
  FIELD(odd, 1, flag, "", "the clocks counted are odd") \
  FIELD(clocks, 4, number, "", "all of them")
#define GRAY_STATE(FIELD)                                  \
  FIELD(count, 4, number, "", "the clocks counted, and 3") \
  FIELD(odd, 1, flag, "", "they are odd")                  \
  FIELD(all, 4, number.unreset(), "", "resets do not matter")
COSIM_RECORDS(GRAY, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  const Condition<V> en = is_set(in.en);
  Step<V> step{s, {}};
  // Of the reset nothing is said here: under it the state is cleared before the clock.
  step.outputs.code = select(bit(s.count, 3), V(8), V(0));
  for (int i = 0; i < 3; ++i) {
    const auto one = bit(s.count, i), other = bit(s.count, i + 1);
    step.outputs.code =
        step.outputs.code + select((one & !other) | (other & !one), V(1 << i), V(0));
  }
  step.outputs.odd = s.odd;
  step.outputs.clocks = s.all;
  step.state.count = select(en, wrap(s.count + V(1), 4), s.count);
  step.state.odd = select(en, V(1) - s.odd, s.odd);
  step.state.all = wrap(s.all + in.en, 4);
  return step;
}

struct Design : faulty::Design {
  COSIM_DESIGN(gray_model);
  static constexpr const char* name = "gray";
  static constexpr Inputs<Word> rest() { return {.rst_n = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {.rst_n = 0}; }
  static constexpr bool asynchronous_reset = true;
  template <class V>
  static constexpr State<V> reset_state() {
    return {V(3), V(0), V(0)};
  }
};

}  // namespace gray_model
