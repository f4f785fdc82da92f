// Golden model of asserted.sv, with its fault.
#pragma once

#include "../../support/fault.h"
#include "model/core/design.h"

namespace asserted_model {

using namespace cosim;
using faulty::Params;

#define ASSERTED_INPUTS(FIELD)               \
  FIELD(rst, 1, flag, "", "begin anew at 0") \
  FIELD(en, 1, flag, "", "count this clock")
#define ASSERTED_OUTPUTS(FIELD) FIELD(count, 4, number, "", "the clocks so far")
#define ASSERTED_STATE(FIELD) FIELD(count, 4, number, "", "the clocks so far")
COSIM_RECORDS(ASSERTED, Params);

inline Step<Word> next(const Params& p, const State<Word>& s, const Inputs<Word>& in) {
  const Word counted = s.count == 9 + p.fault ? 0 : wrap(s.count + 1, 4);
  return {{in.rst != 0 ? 0 : in.en != 0 ? counted : s.count}, {s.count}};
}

struct Design : faulty::Design {
  COSIM_DESIGN(asserted_model);
  static constexpr const char* name = "asserted";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
};

}  // namespace asserted_model
