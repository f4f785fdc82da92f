// Golden model of lock.sv.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace lock_model {

using namespace cosim;
using faulty::Params;

#define LOCK_INPUTS(FIELD)              \
  FIELD(rst, 1, flag, "", "begin anew") \
  FIELD(code, 16, bits, "", "a word")
#define LOCK_OUTPUTS(FIELD)                             \
  FIELD(bell, 1, flag, "", "it is open, and one rings") \
  FIELD(clocks, 4, number, "", "")
#define LOCK_STATE(FIELD)                               \
  FIELD(half_q, 1, flag, "", "the first word was last") \
  FIELD(last_q, 1, flag, "", "the second one was")      \
  FIELD(open_q, 1, flag, "", "both were")               \
  FIELD(clocks_q, 4, number, "", "")
COSIM_RECORDS(LOCK, Params);

template <class V>
constexpr Step<V> next(const Params&, const State<V>& s, const Inputs<V>& in) {
  const auto is_open = is_set(s.open_q), rst = is_set(in.rst);
  const auto both = is_set(s.half_q) & is_set(s.last_q);
  const auto opens = is_set(s.half_q) & (in.code == V(0xbeef));
  State<V> after;
  after.half_q = select(rst, V(0), flag<V>(in.code == V(0xc0de)));
  after.last_q = select(rst, V(0), flag<V>(in.code == V(0xbeef)));
  after.open_q = select(rst, V(0), flag<V>(is_open | opens));
  after.clocks_q = select(rst, V(0), wrap(s.clocks_q + V(1), 4));
  return {after, {flag<V>((is_open & bit(in.code, 0)) | both), s.clocks_q}};
}

struct Design : faulty::Design {
  COSIM_DESIGN(lock_model);
  static constexpr const char* name = "lock";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
};

}  // namespace lock_model
