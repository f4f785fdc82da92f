// Golden model of counter.v.
#pragma once

#include "model/core/design.h"

namespace counter_model {

using namespace cosim;

struct Params {
  int width;
};

#define COUNTER_INPUTS(FIELD)                \
  FIELD(rst, 1, flag, "", "begin anew at 0") \
  FIELD(en, 1, flag, "", "count this clock")
#define COUNTER_OUTPUTS(FIELD)                           \
  FIELD(count, p.width, number, "", "the clocks so far") \
  FIELD(last, 1, flag, "", "the count is all ones")
#define COUNTER_STATE(FIELD) FIELD(total, p.width, number, "", "the clocks so far")
COSIM_RECORDS(COUNTER, Params);

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  const V counted = wrap(s.total + in.en, p.width);
  return {{select(is_set(in.rst), V(0), counted)}, {s.total, flag<V>(s.total == V(ones(p.width)))}};
}

struct Design {
  COSIM_DESIGN(counter_model);
  static constexpr const char* name = "counter";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
  static constexpr std::array<Parameter, 1> parameters(const Params& p) {
    return {{{"W", p.width}}};
  }
};

}  // namespace counter_model
