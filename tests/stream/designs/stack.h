// What passes is as it was, in its order.
#pragma once

#include "../../support/fault.h"
#include "model/core/stream.h"

namespace stack_model {

using namespace cosim;
using faulty::Params;

#define STACK_WORD(FIELD) FIELD(data, 8, number, "", "what passes")
COSIM_RECORD(Passed, STACK_WORD, Params);

struct Design : faulty::Design {
  static constexpr const char* name = "stack";
  static constexpr auto in(const Params&) { return stream<Passed>("x"); }
  static constexpr auto out(const Params&) { return stream<Passed>("y").latency(1); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
  static auto run(const Params&, const std::vector<Passed<Word>>& x) { return x; }
};

}  // namespace stack_model
