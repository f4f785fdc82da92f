// The ends of the parameters' ranges that rtl/shipped.txt leaves out: everything that fits is drawn
// in lockstep, and RTL and model are proved to be the same.
#include <gtest/gtest.h>

#include "model/circular/stated.h"
#include "model/dda/stated.h"
#include "model/linear/stated.h"
#include "tb/designs/circular/sweeps.h"
#include "tb/designs/dda/sweeps.h"
#include "tb/designs/linear/sweeps.h"
#include "tests/rtl/prove.h"
#include "tests/support/sweeps.h"

namespace cosim::test {
namespace {

template <class Design>
const Bench<Design>& shipped(const char* name) {
  return *variant<Design>(std::string("shipped/") + name).bench;
}

TEST(Narrowest, LinearDrawsEveryLine) {
  for (const char* name : {"m2_n1", "m7_n1"}) {
    const auto& bench = shipped<linear::Design>(name);
    const auto sizes = std::uint64_t{1} << bench.params().m;
    EXPECT_EQ(expect_match(linear::every_line(bench)).checked.jobs, sizes * sizes);
  }
}

TEST(Narrowest, CircularDrawsEveryArc) {
  const auto& bench = shipped<circular::Design>("w2");
  EXPECT_EQ(expect_match(every_radius(bench, 1, 3)).checked.jobs, 3U);
  expect_match(every_start(bench, 3));
  expect_match(every_stop(bench, 3));
  expect_match(random_arcs(bench, 1, 500));
}

TEST(Narrowest, DdaDrawsEveryLineAndQuarter) {
  const auto& bench = shipped<dda::Design>("w2");
  expect_match(every_line(bench));
  EXPECT_EQ(expect_match(every_quarter(bench)).checked.jobs, 4U * 3);
  expect_match(random_jobs(bench, 1, 500));
}

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
  expect_proved<linear::Design>();
  expect_proved<circular::Design>();
  expect_proved<dda::Design>();
}

}  // namespace
}  // namespace cosim::test
