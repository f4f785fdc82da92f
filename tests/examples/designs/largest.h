// Golden model of largest.v, a plain one: C++ on machine integers.
#pragma once

#include <algorithm>
#include <vector>

#include "../../support/fault.h"
#include "model/core/design.h"

namespace acme::largest {

using namespace cosim;
using faulty::Params;

#define LARGEST_INPUTS(FIELD)                \
  FIELD(rst, 1, flag, "", "begin anew at 0") \
  FIELD(d, 8, number, "", "the next input")
#define LARGEST_OUTPUTS(FIELD) FIELD(most, 8, number, "", "the largest of the last four")
#define LARGEST_STATE(FIELD)                  \
  FIELD(one, 8, number, "", "the last input") \
  FIELD(two, 8, number, "", "the one before") \
  FIELD(three, 8, number, "", "and before")   \
  FIELD(four, 8, number, "", "and before")
COSIM_RECORDS(LARGEST, Params);

inline Step<Word> next(const Params&, const State<Word>& s, const Inputs<Word>& in) {
  const std::vector<Word> last{s.one, s.two, s.three, s.four};
  Step<Word> step;
  step.outputs.most = *std::max_element(last.begin(), last.end());
  if (in.rst == 0) step.state = {in.d, s.one, s.two, s.three};
  return step;
}

struct Design : faulty::Design {
  COSIM_DESIGN(acme::largest);
  static constexpr const char* name = "largest";
  static constexpr Inputs<Word> reset_inputs() { return {.rst = 1}; }
};

}  // namespace acme::largest
