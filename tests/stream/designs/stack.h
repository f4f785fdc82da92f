// What passes is as it was, in its order.
#pragma once

#include "passing.h"

namespace stack_model {

using namespace cosim;
using passing::Params, passing::Passed;

struct Design : passing::Design {
  static constexpr const char* name = "stack";
  static constexpr auto in(const Params&) { return stream<Passed>("x"); }
  static constexpr auto out(const Params&) { return stream<Passed>("y").latency(1); }
};

}  // namespace stack_model
