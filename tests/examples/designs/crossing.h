// Golden model of crossing.sv.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace crossing_model {

using namespace cosim;
using faulty::Params;

#define CROSSING_INPUTS(FIELD)              \
  FIELD(rst, 1, flag, "", "begin with red") \
  FIELD(walk, 1, flag, "", "somebody wants to walk")
#define CROSSING_OUTPUTS(FIELD)                        \
  FIELD(light, 2, bits, "", "0 red, 1 green, 2 amber") \
  FIELD(stays, 1, flag, "", "it does not change this clock")
#define CROSSING_STATE(FIELD) FIELD(now, 6, bits, "", "the light above the clocks left, four bits")
COSIM_RECORDS(CROSSING, Params);

constexpr int red = 0, green = 1, amber = 2;

template <class V>
constexpr V begun(int light) {
  return join(V(light), V(light == amber ? 2 : 9), 4);
}

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  const V light = slice(s.now, 5, 4), left = slice(s.now, 3, 0);
  const Condition<V> stays = is_set(left);
  const V from_green = select(is_set(in.walk), begun<V>(amber), s.now);
  const V changed = select(light == V(red), begun<V>(green),
                           select(light == V(green), from_green, begun<V>(red)));
  const V after = select(stays, join(light, left - flag<V>(stays), 4), changed);
  return {{select(is_set(in.rst), begun<V>(red), after)}, {light, flag<V>(stays)}};
}

struct Design : faulty::Design {
  COSIM_DESIGN(crossing_model);
  static constexpr const char* name = "crossing";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
  template <class V>
  static constexpr State<V> reset_state() {
    return {begun<V>(red)};
  }
};

}  // namespace crossing_model
