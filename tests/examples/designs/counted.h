// Golden model of counted.sv, with its fault too: what is wrong with that only shows where the
// first register of the synchronizer takes the old value in some bits and the new one in others.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace counted_model {

using namespace cosim;
using faulty::Params;

#define COUNTED_INPUTS(FIELD)                          \
  FIELD(rst_n, 1, flag, "", "0 begins anew, at once")  \
  FIELD(a_clk, 1, rises, "", "the side that counts")   \
  FIELD(tick, 1, flag, "", "there is an event")        \
  FIELD(b_clk, 1, rises, "", "the side that looks on") \
  FIELD(first_new, 4, bits.synchronizer("first"), "", "bits of first that take the new value")
#define COUNTED_OUTPUTS(FIELD) FIELD(seen, 4, number, "", "events seen")
#define COUNTED_STATE(FIELD)                                    \
  FIELD(count, 4, number, "", "events, at most 15")             \
  FIELD(code, 4, bits, "", "the same in the code that crosses") \
  FIELD(first, 4, bits, "", "the code, at the other clock")     \
  FIELD(second, 4, bits, "", "the same, a clock of that later")
COSIM_RECORDS(COUNTED, Params);

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  State<V> a = s;  // where a_clk rises
  a.count = s.count + flag<V>(is_set(in.tick) & s.count < V(15));
  a.code = p.fault != 0 ? a.count : a.count ^ shift_right(a.count, 1);
  Step<V> step{select(is_set(in.a_clk), a, s), {s.second}};
  if (p.fault == 0) {
    for (int i = 1; i < 4; ++i) {
      step.outputs.seen = step.outputs.seen ^ shift_right(s.second, i);
    }
  }
  State<V> b = step.state;  // where b_clk rises
  b.first = s.code;
  b.second = s.first;
  step.state = select(is_set(in.b_clk), b, step.state);
  return step;
}

struct Design : faulty::Design {
  COSIM_DESIGN(counted_model);
  static constexpr const char* name = "counted";
  static constexpr Inputs<Word> rest() { return {.rst_n = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {}; }
  static constexpr bool asynchronous_reset = true;
};

}  // namespace counted_model
