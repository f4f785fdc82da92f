// The ends of the parameters' ranges that rtl/shipped.txt leaves out: RTL and model are proved
// to be the same there. What fits is drawn in lockstep by the tests of each design.
#include <gtest/gtest.h>
#include <algorithm>

#include "tests/rtl/prove.h"
#include "tests/support/designs.h"

namespace cosim::test {
namespace {

bool is_built(const AnyBench& bench) {
  return std::any_of(benches().begin(), benches().end(),
                     [&](const auto& b) { return b->title() == bench.title(); });
}

template <class Design>
void expect_proved() {
  int proved = 0;
  for (const auto& v : variants<Design>()) {
    if (!v.name.starts_with("shipped/") || is_built(*v.bench)) continue;
    const proof::MachineFormula formula = proof::formula<Design>(v.bench->params());
    const proof::Rtl rtl = rtl_of(Design::name, v.name, *v.bench);
    const proof::Claim claims[] = {claim_clear(formula, rtl), claim_step(formula, rtl),
                                   claim_cases(formula, rtl)};
    const auto decided = proof::decide({&claims[0], &claims[1], &claims[2]}, kLimit, 1);
    for (const auto& d : decided) EXPECT_TRUE(d.proved) << v.name << ": " << d.verdict;
    ++proved;
  }
  EXPECT_GT(proved, 0);
}

TEST(Narrowest, IsProved) {
  if (!can_prove()) GTEST_SKIP() << "needs yosys, cvc5 and z3";
  for_each_design([]<class Design>() { expect_proved<Design>(); });
}

}  // namespace
}  // namespace cosim::test
