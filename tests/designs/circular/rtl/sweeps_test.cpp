// Sweeps on RTL other than as shipped: at the ends of the parameters' ranges that rtl/shipped.txt
// leaves out, with a fault, and as a netlist.
#include "tb/designs/circular/sweeps.h"
#include "tests/designs/circular/counts.h"
#include "tests/designs/circular/printed.h"
#include "tests/rtl/netlist.h"
#include "tests/rtl/variant_lanes.h"
#include "tests/support/sweeps.h"

namespace cosim::circular {
namespace {

TEST(Narrowest, CircularDrawsEveryArc) {
  const auto& bench = *test::variant<Design>("shipped/w2").bench;
  EXPECT_EQ(test::expect_match(every_radius(bench, 1, 3)).checked.jobs, 3U);
  test::expect_match(every_start(bench, 3));
  test::expect_match(every_stop(bench, 3));
  test::expect_match(random_arcs(bench, 1, 500));
}

TEST(CircularLanesOfJobs, FindWhatOneAtATimeFinds) {
  const auto& v = test::variant<Design>("faults/two_from_one");
  test::expect_jobs_find(v, random_arcs(*v.bench, 1, 20'000));
}

TEST(CircularNetlist, MatchesOnHostileClocksAndDrawsEveryArc) {
  const auto* bench = test::netlist<Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  test::expect_match_on_hostile_clocks(*bench);
  printed::expect_tables(*bench);
  counted::expect_every_start(*bench, ones(width_of(bench->params())));
  counted::expect_every_stop(*bench, ones(width_of(bench->params())));
}

}  // namespace
}  // namespace cosim::circular
