// Golden model of domains.v.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace domains_model {

using namespace cosim;
using faulty::Params;

#define DOMAINS_INPUTS(FIELD)                          \
  FIELD(a_clk, 1, rises, "", "the side that sends")    \
  FIELD(a_rst, 1, flag, "", "resets it, at its clock") \
  FIELD(send, 1, flag, "", "there is an event")        \
  FIELD(b_clk, 1, falls, "", "the side that counts")   \
  FIELD(b_rst_n, 1, flag, "", "resets it where it is 0, at once")
#define DOMAINS_OUTPUTS(FIELD) FIELD(q, 3, number, "", "events seen")
#define DOMAINS_STATE(FIELD)                        \
  FIELD(turned, 1, flag, "", "over, on each event") \
  FIELD(first, 1, flag, "", "the same, sampled")    \
  FIELD(second, 1, flag, "", "a clock later")       \
  FIELD(last, 1, flag, "", "two clocks later")      \
  FIELD(seen, 3, number, "", "events seen")
COSIM_RECORDS(DOMAINS, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  State<V> a = s;  // where a_clk rises
  a.turned = select(is_set(in.a_rst), V(0), s.turned ^ in.send);
  State<V> b = s;  // where b_clk falls
  b.first = s.turned;
  b.second = s.first;
  b.last = s.second;
  b.seen = wrap(s.seen + (s.second ^ s.last), 3);

  Step<V> step{select(is_set(in.b_clk), b, s), {s.seen}};
  step.state.turned = select(is_set(in.a_clk), a.turned, s.turned);
  return step;
}

template <class V>
constexpr State<V> reset(const Params&, const State<V>& s, const Inputs<V>& in) {
  State<V> b{};
  b.turned = s.turned;
  return select(is_set(in.b_rst_n), s, b);
}

struct Design : faulty::Design {
  COSIM_DESIGN(domains_model);
  static constexpr const char* name = "domains";
  static constexpr Inputs<Word> rest() { return {.b_rst_n = 1}; }
  static constexpr Inputs<Word> reset_inputs() { return {.a_rst = 1}; }
};

}  // namespace domains_model
