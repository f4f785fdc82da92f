// Golden model of onehot.sv, whose registers it does not have.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace onehot_model {

using namespace cosim;
using faulty::Params;

#define ONEHOT_INPUTS(FIELD)            \
  FIELD(rst, 1, flag, "", "to place 0") \
  FIELD(go, 1, flag, "", "to the next one")
#define ONEHOT_OUTPUTS(FIELD)     \
  FIELD(place, 3, number, "", "") \
  FIELD(last, 1, flag, "", "the place is 4")
#define ONEHOT_STATE(FIELD) FIELD(place, 3, number, "", "0 to 4")
#define ONEHOT_REGISTERS(FIELD)
COSIM_RECORDS(ONEHOT, Params);
COSIM_RECORD(Registers, ONEHOT_REGISTERS, Params);

template <class V>
constexpr Registers<V> registers(const Params&, const State<V>&) {
  return {};
}

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  const auto last = s.place == V(4);
  const V after = select(last, V(0), wrap(s.place + V(1), 3));
  return {{select(is_set(in.rst), V(0), select(is_set(in.go), after, s.place))},
          {s.place, flag<V>(last)}};
}

struct Design : faulty::Design {
  COSIM_DESIGN(onehot_model);
  static constexpr const char* name = "onehot";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
  static constexpr std::array unobserved{"ring"};
};

}  // namespace onehot_model
