// Golden model of laps.v.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace laps_model {

using namespace cosim;
using faulty::Params;

#define LAPS_INPUTS(FIELD)                          \
  FIELD(rst_n, 1, flag, "", "0: all anew, at once") \
  FIELD(lap, 1, flag, "", "1: a new lap, at once")  \
  FIELD(en, 1, flag, "", "count this clock")
#define LAPS_OUTPUTS(FIELD)                                 \
  FIELD(clocks, 6, number, "", "counted")                   \
  FIELD(since, 4, number, "", "of them in this lap, and 1") \
  FIELD(longest, 4, number, "", "the most there was")
#define LAPS_STATE(FIELD)         \
  FIELD(count, 6, number, "", "") \
  FIELD(part, 4, number, "", "")  \
  FIELD(most, 4, number, "", "")
COSIM_RECORDS(LAPS, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  Step<V> step{s, {s.count, s.part, s.most}};
  step.state.count = wrap(s.count + in.en, 6);
  step.state.part = wrap(s.part + in.en, 4);
  step.state.most = select(is_set(in.rst_n), select(s.most < s.part, s.part, s.most), V(0));
  return step;
}

/// Under the resets that do not wait for the clock.
template <class V>
constexpr State<V> reset(const Params&, State<V> s, const Inputs<V>& in) {
  s.count = select(is_set(in.rst_n), s.count, V(0));
  s.part = select(is_set(in.lap), V(1), s.part);
  return s;
}

struct Design : faulty::Design {
  COSIM_DESIGN(laps_model);
  static constexpr const char* name = "laps";
  static constexpr Inputs<Word> rest() { return {.rst_n = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {.rst_n = 0, .lap = 1}; }
  template <class V>
  static constexpr State<V> reset_state() {
    return {V(0), V(1), V(0)};
  }
};

}  // namespace laps_model
