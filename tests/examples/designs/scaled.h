// Golden model of scaled.v.
#pragma once

#include "model/core/design.h"

namespace scaled_model {

using namespace cosim;

struct Params {
  int fault, width;
};

#define SCALED_INPUTS(FIELD)                 \
  FIELD(rst, 1, flag, "", "begin anew at 0") \
  FIELD(d, p.width, number, "", "added three times")
#define SCALED_OUTPUTS(FIELD) FIELD(sum, p.width, number, "", "the sum so far")
#define SCALED_STATE(FIELD) FIELD(total, p.width, number, "", "the sum so far")
COSIM_RECORDS(SCALED, Params);

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  const V sum = wrap(s.total + in.d + in.d + in.d, p.width);
  return {{select(is_set(in.rst), V(0), sum)}, {s.total}};
}

struct Design {
  COSIM_DESIGN(scaled_model);
  static constexpr const char* name = "scaled";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
  static constexpr std::array<Parameter, 2> parameters(const Params& p) {
    return {{{"FAULT", p.fault}, {"W", p.width}}};
  }
};

}  // namespace scaled_model
