// What passes from one clock to another is as it was, in its order.
#pragma once

#include "../../support/fault.h"
#include "model/core/stream.h"

namespace crosses_model {

using namespace cosim;
using faulty::Params;

#define CROSSES_WORD(FIELD) FIELD(data, 8, number, "", "what passes")
COSIM_RECORD(Passed, CROSSES_WORD, Params);

struct Design : faulty::Design {
  static constexpr const char* name = "crosses";
  static constexpr auto in(const Params&) { return stream<Passed>("x").clock("fast"); }
  static constexpr auto out(const Params&) { return stream<Passed>("y").clock("slow"); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
  static auto run(const Params&, const std::vector<Passed<Word>>& x) { return x; }
};

}  // namespace crosses_model
