// Sweeps on RTL at the ends of the parameters' ranges that rtl/shipped.txt leaves out, and on RTL
// with a fault.
#include "tb/designs/circular/sweeps.h"
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

}  // namespace
}  // namespace cosim::circular
