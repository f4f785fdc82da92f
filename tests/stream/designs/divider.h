// Start and done in place of ready and valid, and a rule of what may go in.
#pragma once

#include "../../support/fault.h"
#include "model/core/stated.h"
#include "model/core/stream.h"

namespace divider_model {

using namespace cosim;
using faulty::Params;

#define DIVIDER_ASKED(FIELD)             \
  FIELD(dividend, 8, number, "", "what") \
  FIELD(divisor, 8, number, "", "by what")
#define DIVIDER_GIVEN(FIELD)                       \
  FIELD(quotient, 8, number, "", "how many times") \
  FIELD(remainder, 8, number, "", "what is left")
COSIM_RECORD(Asked, DIVIDER_ASKED, Params);
COSIM_RECORD(Given, DIVIDER_GIVEN, Params);

struct Design : faulty::Design {
  static constexpr const char* name = "divider";
  static constexpr auto in(const Params&) {
    return stream<Asked>("asked").prefix("").valid("start").until("done");
  }
  static constexpr auto out(const Params&) {
    return stream<Given>("given").prefix("").valid("done").rising().latency(10).steady();
  }
  static constexpr auto pins(const Params&) { return std::array{pin::reset("rst")}; }
  static std::array<Stated<Word>, 1> legal(const Params&, const Asked<Word>& asked) {
    return {{{"the divisor is not 0", asked.divisor != 0}}};
  }
  static std::vector<Given<Word>> run(const Params&, const std::vector<Asked<Word>>& asked) {
    std::vector<Given<Word>> given;
    for (const auto& a : asked) given.push_back({a.dividend / a.divisor, a.dividend % a.divisor});
    return given;
  }
};

}  // namespace divider_model
