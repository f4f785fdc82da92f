// What passes is as it was.
#pragma once

#include "passing.h"

namespace asserts_model {

using namespace cosim;
using passing::Params, passing::Passed;

struct Design : passing::Design {
  static constexpr const char* name = "asserts";
  static constexpr auto in(const Params&) { return stream<Passed>("x"); }
  static constexpr auto out(const Params&) { return stream<Passed>("y").latency(1).steady(); }
};

}  // namespace asserts_model
