// Golden model of timer.vhd.
#pragma once

#include "model/core/design.h"

namespace timer_model {

using namespace cosim;

struct Params {
  int width;
};

#define TIMER_INPUTS(FIELD)                          \
  FIELD(rst, 1, flag, "", "give up")                 \
  FIELD(start, 1, flag, "", "begin, where it idles") \
  FIELD(load, p.width, number, "", "clocks to count")
#define TIMER_OUTPUTS(FIELD)                   \
  FIELD(busy, 1, flag, "", "it does not idle") \
  FIELD(done, 1, flag, "", "the time is over")
#define TIMER_STATE(FIELD)                                        \
  FIELD(state, 2, number, "", "0 idles, 1 runs, 2 is at the end") \
  FIELD(count, p.width, number, "", "clocks that are left")       \
  FIELD(done_q, 1, flag, "", "the time is over")
COSIM_RECORDS(TIMER, Params);

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  const auto idles = s.state == V(0), runs = s.state == V(1), is_over = s.count == V(0);
  State<V> after;
  after.state = select(idles, select(is_set(in.start), V(1), V(0)),  //
                       select(runs, select(is_over, V(2), V(1)), V(0)));
  after.count = select(idles & is_set(in.start), in.load,
                       select(runs & !is_over, wrap(s.count - V(1), p.width), s.count));
  after.done_q = flag<V>(s.state == V(2));
  const auto given_up = is_set(in.rst);
  after.state = select(given_up, V(0), after.state);
  after.count = select(given_up, V(0), after.count);
  after.done_q = select(given_up, V(0), after.done_q);
  return {after, {flag<V>(!idles), s.done_q}};
}

struct Design {
  COSIM_DESIGN(timer_model);
  static constexpr const char* name = "timer";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
  static constexpr std::array<Parameter, 1> parameters(const Params& p) {
    return {{{"WIDTH", p.width}}};
  }
};

}  // namespace timer_model
