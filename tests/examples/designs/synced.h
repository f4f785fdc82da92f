// Golden model of synced.v.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace synced_model {

using namespace cosim;
using faulty::Params;

#define SYNCED_INPUTS(FIELD)                                \
  FIELD(reset, 1, flag, "", "on the third clock from here") \
  FIELD(en, 1, flag, "", "count this clock")
#define SYNCED_OUTPUTS(FIELD) FIELD(q, 3, number, "", "the count")
#define SYNCED_STATE(FIELD)                           \
  FIELD(first, 1, flag, "", "reset, one clock ago")   \
  FIELD(second, 1, flag, "", "reset, two clocks ago") \
  FIELD(count, 3, number, "", "the count")
COSIM_RECORDS(SYNCED, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  return {{in.reset, s.first, select(is_set(s.second), V(0), wrap(s.count + in.en, 3))}, {s.count}};
}

struct Design : faulty::Design {
  COSIM_DESIGN(synced_model);
  static constexpr const char* name = "synced";
  static constexpr Inputs<Word> reset_inputs() { return {.reset = 1}; }
  static constexpr int reset_clocks = 3;
  template <class V>
  static constexpr State<V> reset_state() {
    return {V(1), V(1), V(0)};
  }
};

}  // namespace synced_model
