// Golden model of folded.v.
#pragma once

#include "model/core/design.h"

namespace folded_model {

using namespace cosim;

struct Params {
  int fault, tags, drops;
};

#define FOLDED_INPUTS(FIELD)  \
  FIELD(rst, 1, flag, "", "") \
  FIELD(d, 4, bits, "", "")   \
  FIELD(valid, 1, flag, "", "")
#define FOLDED_OUTPUTS(FIELD)     \
  FIELD(q, 4, bits, "", "")       \
  FIELD(tag, 4, bits, "", "")     \
  FIELD(dropped, 1, flag, "", "") \
  FIELD(bad, 1, flag, "", "")
#define FOLDED_STATE(FIELD)                                                         \
  FIELD(q, 4, bits.unreset(), "", "")                                               \
  FIELD(held, 4, bits.at("tags.held").unreset(), "", "drives nothing without TAGS") \
  FIELD(dropped, 1, flag, "", "0 without DROPS")                                    \
  FIELD(bad, 1, flag, "", "the same")                                               \
  FIELD(count, 2, number, "", "")
COSIM_RECORDS(FOLDED, Params);

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  Step<V> step{s, {s.q, p.tags ? s.held : V(0), s.dropped, s.bad}};
  const auto valid = is_set(in.valid), rst = is_set(in.rst);
  const V drop = p.drops ? flag<V>(valid & (s.count == V(3))) : V(0);
  step.state.q = select(valid, in.d, s.q);
  step.state.held = select(valid, in.d, s.held);
  step.state.dropped = step.state.bad = select(rst, V(0), drop);
  step.state.count = select(rst, V(0), select(valid, wrap(s.count + V(1), 2), s.count));
  return step;
}

struct Design {
  COSIM_DESIGN(folded_model);
  static constexpr const char* name = "folded";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
  static constexpr std::array<Parameter, 3> parameters(const Params& p) {
    return {{{"FAULT", p.fault}, {"TAGS", p.tags}, {"DROPS", p.drops}}};
  }
};

}  // namespace folded_model
