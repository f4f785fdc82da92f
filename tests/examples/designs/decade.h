// Golden model of decade.sv. It has no invariant.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace decade_model {

using namespace cosim;
using faulty::Params;

#define DECADE_INPUTS(FIELD)            \
  FIELD(rst, 1, flag, "", "begin anew") \
  FIELD(en, 1, flag, "", "count this clock")
#define DECADE_OUTPUTS(FIELD)     \
  FIELD(digit, 4, number, "", "") \
  FIELD(carry, 1, flag, "", "ten clocks were counted")
#define DECADE_STATE(FIELD) FIELD(digit_q, 4, number, "", "0 to 9")
COSIM_RECORDS(DECADE, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  const auto en = is_set(in.en), carry = en & (s.digit_q == V(9));
  const V after = select(carry, V(0), select(en, wrap(s.digit_q + V(1), 4), s.digit_q));
  return {{select(is_set(in.rst), V(0), after)}, {s.digit_q, flag<V>(carry)}};
}

struct Design : faulty::Design {
  COSIM_DESIGN(decade_model);
  static constexpr const char* name = "decade";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
};

}  // namespace decade_model
