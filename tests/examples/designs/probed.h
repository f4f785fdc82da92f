// Golden model of probed.v.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace probed_model {

using namespace cosim;
using faulty::Params;

#define PROBED_INPUTS(FIELD)                 \
  FIELD(rst, 1, flag, "", "begin anew at 0") \
  FIELD(en, 1, flag, "", "count this clock")
#define PROBED_OUTPUTS(FIELD) FIELD(q, 4, number, "", "the count")
// The register is counter.value; `count` of the top carries it.
#define PROBED_STATE(FIELD) FIELD(count, 4, number, "", "the count")
COSIM_RECORDS(PROBED, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  return {{select(is_set(in.rst), V(0), wrap(s.count + in.en, 4))}, {s.count}};
}

struct Design : faulty::Design {
  COSIM_DESIGN(probed_model);
  static constexpr const char* name = "probed";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
  static constexpr std::array unobserved{"debug.*", "spare"};
};

}  // namespace probed_model
