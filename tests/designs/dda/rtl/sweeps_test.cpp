// Sweeps on RTL other than as shipped: at the ends of the parameters' ranges that rtl/shipped.txt
// leaves out, with a fault, and as a netlist.
#include "tb/designs/dda/sweeps.h"
#include "tests/rtl/netlist.h"
#include "tests/rtl/variant_lanes.h"
#include "tests/support/sweeps.h"

namespace cosim::dda {
namespace {

TEST(Narrowest, DdaDrawsEveryLineAndQuarter) {
  const auto& bench = *test::variant<Design>("shipped/w2").bench;
  test::expect_match(every_line(bench));
  EXPECT_EQ(test::expect_match(every_quarter(bench)).checked.jobs, 4U * 3);
  test::expect_match(random_jobs(bench, 1, 500));
}

TEST(DdaLanesOfJobs, FindWhatOneAtATimeFinds) {
  const auto& v = test::variant<Design>("faults/half_backwards_shifted");
  test::expect_jobs_find(v, random_lines_and_arcs(*v.bench, 1, 20'000));
}

TEST(DdaNetlist, MatchesOnHostileClocks) {
  const auto* bench = test::netlist<Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  test::expect_match_on_hostile_clocks(*bench);
}

TEST(DdaNetlist, DrawsEveryQuarter) {
  const auto* bench = test::netlist<Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  test::expect_match(every_quarter(*bench));
  test::expect_match(random_jobs(*bench, 1, 500));
}

}  // namespace
}  // namespace cosim::dda
