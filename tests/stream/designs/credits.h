// Credits on both sides.
#pragma once

#include "../../support/fault.h"
#include "model/core/stream.h"

namespace credits_model {

using namespace cosim;
using faulty::Params;

#define CREDITS_WORD(FIELD) FIELD(word, 16, bits, "", "what passes")
COSIM_RECORD(Passed, CREDITS_WORD, Params);

struct Design : faulty::Design {
  static constexpr const char* name = "credits";
  static constexpr auto in(const Params&) { return stream<Passed>("in").credit(4); }
  static constexpr auto out(const Params&) { return stream<Passed>("out").credit(2); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
  static auto run(const Params&, const std::vector<Passed<Word>>& in) { return in; }
};

}  // namespace credits_model
