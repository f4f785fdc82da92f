// What passes is as it was, in its order.
#pragma once

#include "../../support/fault.h"
#include "model/core/stream.h"

namespace keeps_model {

using namespace cosim;
using faulty::Params;

#define KEEPS_WORD(FIELD) FIELD(data, 8, number, "", "what passes")
COSIM_RECORD(Passed, KEEPS_WORD, Params);

struct Design : faulty::Design {
  static constexpr const char* name = "keeps";
  static constexpr auto in(const Params&) { return stream<Passed>("x"); }
  static constexpr auto out(const Params&) { return stream<Passed>("y"); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
  static auto run(const Params&, const std::vector<Passed<Word>>& x) { return x; }
};

}  // namespace keeps_model
