// Golden model of skid.v. Its state has more than the registers: how many bytes were taken. What no
// reset reaches is taken over by name all the same.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace skid_model {

using namespace cosim;
using faulty::Params;

#define SKID_INPUTS(FIELD)                          \
  FIELD(rst, 1, flag, "", "begin anew")             \
  FIELD(in_valid, 1, flag, "", "a byte is offered") \
  FIELD(in_data, 8, bits, "", "that byte")          \
  FIELD(out_ready, 1, flag, "", "the byte is taken")
#define SKID_OUTPUTS(FIELD)                                \
  FIELD(in_ready, 1, flag, "", "what is offered is taken") \
  FIELD(out_valid, 1, flag, "", "a byte is there")         \
  FIELD(out_data, 8, bits, "", "the last one")
#define SKID_REGISTERS(FIELD)                      \
  FIELD(out_valid, 1, flag, "", "a byte is there") \
  FIELD(out_data, 8, bits.unreset(), "", "the last one")
#define SKID_STATE(FIELD)                              \
  FIELD(taken, 8, number, "", "bytes that were taken") \
  SKID_REGISTERS(FIELD)
COSIM_RECORDS(SKID, Params);
COSIM_RECORD(Registers, SKID_REGISTERS, Params);

template <class V>
constexpr Registers<V> registers(const Params&, const State<V>& s) {
  return {s.out_valid, s.out_data};
}
template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  const Condition<V> ready = !is_set(s.out_valid) | is_set(in.out_ready), rst = is_set(in.rst);
  Step<V> step{s, {flag<V>(ready), s.out_valid, s.out_data}};
  step.state.taken = select(rst, V(0), wrap(s.taken + flag<V>(ready & is_set(in.in_valid)), 8));
  step.state.out_valid = select(rst, V(0), select(ready, in.in_valid, s.out_valid));
  step.state.out_data = select(ready & is_set(in.in_valid), in.in_data, s.out_data);
  return step;
}

struct Design : faulty::Design {
  COSIM_DESIGN(skid_model);
  static constexpr const char* name = "skid";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
};

}  // namespace skid_model
