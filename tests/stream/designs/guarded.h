// Both models of guarded.sv: what passes is as it was, and what it does on every clock.
#pragma once

#include "../../support/fault.h"
#include "model/core/bit_strings.h"
#include "model/core/design.h"
#include "model/core/stated.h"
#include "model/core/stream.h"

namespace guarded_model {

using namespace cosim;
using faulty::Params;

#define GUARDED_INPUTS(FIELD)                        \
  FIELD(rst, 1, flag, "", "nothing is held")         \
  FIELD(x_valid, 1, flag, "", "a number is offered") \
  FIELD(x_data, 8, number, "", "it")                 \
  FIELD(y_ready, 1, flag, "", "what is held is taken")
#define GUARDED_OUTPUTS(FIELD)                     \
  FIELD(x_ready, 1, flag, "", "a number is taken") \
  FIELD(y_valid, 1, flag, "", "a number is held")  \
  FIELD(y_data, 8, number, "", "it")
#define GUARDED_STATE(FIELD)                      \
  FIELD(y_valid, 1, flag, "", "a number is held") \
  FIELD(y_data, 8, number.unreset(), "", "it")    \
  FIELD(odd, 1, flag.unreset(), "", "its parity")
COSIM_RECORDS(GUARDED, Params);
#define GUARDED_WORD(FIELD) FIELD(data, 8, number, "", "what passes")
COSIM_RECORD(Passed, GUARDED_WORD, Params);

template <class V>
constexpr Condition<V> is_odd(const Params& p, V data) {
  const auto odd = parity(data, 8);
  return p.fault != 0 ? odd ^ (data > V(100)) : odd;
}

template <class V>
constexpr Step<V> next(const Params& p, const State<V>& s, const Inputs<V>& in) {
  const auto takes = !is_set(s.y_valid) | is_set(in.y_ready);
  Step<V> step{s, {flag<V>(takes), s.y_valid, s.y_data}};
  step.state.y_valid = select(is_set(in.rst), V(0), select(takes, in.x_valid, s.y_valid));
  step.state.y_data = select(takes, in.x_data, s.y_data);
  step.state.odd = select(takes, flag<V>(is_odd(p, in.x_data)), s.odd);
  return step;
}

template <class V>
constexpr auto invariant(const Params& p, const State<V>& s) {
  return std::array{Stated<V>{"the parity is that of what is held",
                              !is_set(s.y_valid) | !(is_set(s.odd) ^ is_odd(p, s.y_data))}};
}

struct Design : faulty::Design {
  COSIM_DESIGN(guarded_model);
  static constexpr const char* name = "guarded";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }

  static constexpr auto in(const Params&) { return stream<Passed>("x"); }
  static constexpr auto out(const Params&) { return stream<Passed>("y").latency(1).steady(); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
  static auto run(const Params&, const std::vector<Passed<Word>>& x) { return x; }
};

}  // namespace guarded_model
