// What passes is as it was, in its order.
#pragma once

#include "model/core/stream.h"

namespace keeps_model {

using namespace cosim;

struct Params {
  int fault;
};

#define KEEPS_WORD(FIELD) FIELD(data, 8, number, "", "what passes")
COSIM_RECORD(Passed, KEEPS_WORD, Params);

struct Design {
  using Params = keeps_model::Params;
  static constexpr const char* name = "keeps";
  static constexpr auto parameters(const Params& p) {
    return std::array<Parameter, 1>{{{"FAULT", p.fault}}};
  }
  static constexpr auto in(const Params&) { return stream<Passed>("x"); }
  static constexpr auto out(const Params&) { return stream<Passed>("y"); }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
  static auto run(const Params&, const std::vector<Passed<Word>>& x) { return x; }
};

}  // namespace keeps_model
