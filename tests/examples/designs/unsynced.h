// Golden model of unsynced.sv, with its fault too.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace unsynced_model {

using namespace cosim;
using faulty::Params;

#define UNSYNCED_INPUTS(FIELD)                                                     \
  FIELD(a_clk, 1, rises, "", "the clock of the level")                             \
  FIELD(a_rst_n, 1, flag, "", "0 resets the level, at once")                       \
  FIELD(turn, 1, flag, "", "it changes")                                           \
  FIELD(b_clk, 1, rises, "", "the clock of what follows it")                       \
  FIELD(b_rst, 1, flag, "", "resets that, at once")                                \
  FIELD(first_new, 1, bits.synchronizer("first"), "", "first takes the new value") \
  FIELD(idle_new, 1, bits.synchronizer("idle"), "", "idle does")                   \
  FIELD(busy_new, 1, bits.synchronizer("busy"), "", "busy does")
#define UNSYNCED_OUTPUTS(FIELD) FIELD(works, 1, flag, "", "it is busy")
#define UNSYNCED_STATE(FIELD)                              \
  FIELD(level, 1, flag, "", "")                            \
  FIELD(first, 1, flag, "", "the level, sampled")          \
  FIELD(second, 1, flag, "", "the same, a clock later")    \
  FIELD(idle, 1, flag, "", "the level as it is seen is 0") \
  FIELD(busy, 1, flag, "", "it is 1")
COSIM_RECORDS(UNSYNCED, Params);

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  const V level_here = p.fault != 0 ? s.level : s.second;
  Step<V> step{s, {s.busy}};
  step.state.level = select(is_set(in.a_clk), s.level ^ in.turn, s.level);
  State<V> b = step.state;  // where b_clk rises
  b.first = s.level;
  b.second = s.first;
  b.idle = level_here ^ V(1);
  b.busy = level_here;
  step.state = select(is_set(in.b_clk), b, step.state);
  return step;
}

template <class V>
constexpr State<V> reset(const Params&, const State<V>& s, const Inputs<V>& in) {
  State<V> a = s;
  a.level = V(0);
  State<V> b = select(is_set(in.a_rst_n), s, a), kept = b;
  b.first = V(0);
  b.second = V(0);
  b.idle = V(1);
  b.busy = V(0);
  return select(is_set(in.b_rst), b, kept);
}

struct Design : faulty::Design {
  COSIM_DESIGN(unsynced_model);
  static constexpr const char* name = "unsynced";
  static constexpr Inputs<Word> rest() { return {.a_rst_n = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {.b_rst = 1}; }
  template <class V>
  static constexpr State<V> reset_state() {
    State<V> s{};
    s.idle = V(1);
    return s;
  }
};

}  // namespace unsynced_model
