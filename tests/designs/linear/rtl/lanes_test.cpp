// Lines in lanes, on RTL with a fault.
#include "tb/designs/linear/sweeps.h"
#include "tests/rtl/variant_lanes.h"

namespace cosim::linear {
namespace {

TEST(LinearLanesOfJobs, FindWhatOneAtATimeFinds) {
  const auto& v = test::variant<Design>("faults/rom2_entry");
  test::expect_jobs_find(v, random_lines(*v.bench, 1, 20'000));
}

}  // namespace
}  // namespace cosim::linear
