// Golden model of alu.v: a function of the inputs.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace alu_model {

using namespace cosim;
using faulty::Params;

#define ALU_INPUTS(FIELD)     \
  FIELD(a, 8, number, "", "") \
  FIELD(b, 8, number, "", "") \
  FIELD(operation, 2, number, "", "add, subtract, and, exclusive or")
#define ALU_OUTPUTS(FIELD)                    \
  FIELD(result, 8, number, "", "")            \
  FIELD(zero, 1, flag, "", "the result is 0") \
  FIELD(carry, 1, flag, "", "out of the highest bit, or borrowed")
#define ALU_STATE(FIELD)
COSIM_RECORDS(ALU, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  Step<V> step{s, {}};
  const V sum = in.a + in.b, difference = in.a - in.b;
  const auto is = [&](int operation) { return in.operation == V(operation); };
  step.outputs.result =
      select(is(0), wrap(sum, 8),
             select(is(1), wrap(difference, 8), select(is(2), in.a & in.b, in.a ^ in.b)));
  step.outputs.zero = flag<V>(step.outputs.result == V(0));
  step.outputs.carry = flag<V>((is(0) & !(sum < V(256))) | (is(1) & (difference < V(0))));
  return step;
}

struct Design : faulty::Design {
  COSIM_DESIGN(alu_model);
  static constexpr const char* name = "alu";
};

}  // namespace alu_model
