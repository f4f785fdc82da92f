// Golden model of scratchpad.v.
#pragma once

#include "model/core/design.h"
#include "model/core/memory.h"

namespace scratchpad_model {

using namespace cosim;

struct Params {};

#define SCRATCHPAD_INPUTS(FIELD)                                        \
  FIELD(resetn, 1, flag, "", "0: nothing is saved")                     \
  FIELD(fill, 1, flag, "", "all registers from line")                   \
  FIELD(line, 32, bits.array<16>(), "", "a line of the memory")         \
  FIELD(save, 1, flag, "", "all registers to saved")                    \
  FIELD(write, 1, flag, "", "data to register target, unless all fill") \
  FIELD(target, 4, number, "", "a register")                            \
  FIELD(data, 32, bits, "", "what is written")                          \
  FIELD(source_a, 4, number, "", "a register")                          \
  FIELD(source_b, 4, number, "", "another, or the same")
#define SCRATCHPAD_OUTPUTS(FIELD)                               \
  FIELD(saved, 32, bits.array<16>(), "", "what was last saved") \
  FIELD(fresh, 1, flag, "", "saved is what the registers hold") \
  FIELD(a, 32, bits, "", "register source_a")                   \
  FIELD(b, 32, bits, "", "register source_b")
#define SCRATCHPAD_STATE(FIELD)                                                   \
  FIELD(r, 32, bits.array<16>().at("registers.r").unreset(), "", "the registers") \
  FIELD(saved, 32, bits.array<16>(), "", "what was last saved")                   \
  FIELD(fresh, 1, flag, "", "saved is what the registers hold")
COSIM_RECORDS(SCRATCHPAD, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  const auto reset = !is_set(in.resetn), fill = is_set(in.fill), save = is_set(in.save);
  const auto write = is_set(in.write);
  Step<V> step;
  step.outputs = {s.saved, s.fresh, read(s.r, in.source_a), read(s.r, in.source_b)};
  step.state.r = select(fill, in.line, write_where(write, s.r, in.target, in.data));
  step.state.saved = select(reset, Array<V, 16>{}, select(save, s.r, s.saved));
  step.state.fresh = select(reset, V(0), flag<V>((is_set(s.fresh) | save) & !(fill | write)));
  return step;
}

struct Design {
  COSIM_DESIGN(scratchpad_model);
  static constexpr const char* name = "scratchpad";
  static constexpr Inputs<Word> rest() { return {.resetn = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {.resetn = 0}; }
};

}  // namespace scratchpad_model
