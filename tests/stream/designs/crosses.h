// What passes from one clock to another is as it was, in its order.
#pragma once

#include "passing.h"

namespace crosses_model {

using namespace cosim;
using passing::Params, passing::Passed;

struct Design : passing::Design {
  static constexpr const char* name = "crosses";
  static constexpr auto in(const Params&) { return stream<Passed>("x").clock("fast"); }
  static constexpr auto out(const Params&) { return stream<Passed>("y").clock("slow"); }
};

}  // namespace crosses_model
