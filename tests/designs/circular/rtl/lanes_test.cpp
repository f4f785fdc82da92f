// Arcs in lanes, on RTL with a fault.
#include "tb/designs/circular/sweeps.h"
#include "tests/rtl/variant_lanes.h"

namespace cosim::circular {
namespace {

TEST(CircularLanesOfJobs, FindWhatOneAtATimeFinds) {
  const auto& v = test::variant<Design>("faults/two_from_one");
  test::expect_jobs_find(v, random_arcs(*v.bench, 1, 20'000));
}

}  // namespace
}  // namespace cosim::circular
