// What passes is as it was, in its order: what most streams here are models of.
#pragma once

#include "../../support/fault.h"
#include "model/core/stream.h"

namespace passing {

using namespace cosim;
using faulty::Params;

#define PASSING_WORD(FIELD) FIELD(data, 8, number, "", "what passes")
COSIM_RECORD(Passed, PASSING_WORD, Params);

struct Design : faulty::Design {
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
  static auto run(const Params&, const std::vector<Passed<Word>>& x) { return x; }
};

}  // namespace passing
