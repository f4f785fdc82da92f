// What passes is as it was.
#pragma once

#include "../../support/fault.h"
#include "model/core/stream.h"

namespace asserts_model {

using namespace cosim;
using faulty::Params;

#define ASSERTS_WORD(FIELD) FIELD(data, 8, number, "", "what passes")
COSIM_RECORD(Passed, ASSERTS_WORD, Params);

struct Design : faulty::Design {
  static constexpr const char* name = "asserts";
  static constexpr auto in(const Params&) { return stream<Passed>("x"); }
  static constexpr auto out(const Params&) { return stream<Passed>("y").latency(1).steady(); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
  static auto run(const Params&, const std::vector<Passed<Word>>& x) { return x; }
};

}  // namespace asserts_model
