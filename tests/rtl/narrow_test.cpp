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
    const auto claims = claims_of(nets::model_of<Design>(v.bench->params()),
                                  source_of(Design::name, v.name, *v.bench));
    std::vector<const proof::Claim*> all;
    for (const proof::Claim& c : claims) all.push_back(&c);
    const auto decided = proof::decide(all, {proof::all_engines(), kLimit, 1});
    for (const auto& d : decided) EXPECT_TRUE(d.proved) << v.name << ": " << d.verdict;
    ++proved;
  }
  EXPECT_GT(proved, 0);
}

TEST(Narrowest, IsProved) {
  if (!can_prove()) GTEST_SKIP() << "needs yosys";
  for_each_design([]<class Design>() { expect_proved<Design>(); });
}

}  // namespace
}  // namespace cosim::test
