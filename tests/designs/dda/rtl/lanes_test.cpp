// Lines and arcs in lanes, on RTL with a fault.
#include "tb/designs/dda/sweeps.h"
#include "tests/rtl/variant_lanes.h"

namespace cosim::dda {
namespace {

TEST(DdaLanesOfJobs, FindWhatOneAtATimeFinds) {
  const auto& v = test::variant<Design>("faults/half_backwards_shifted");
  test::expect_jobs_find(v, random_lines_and_arcs(*v.bench, 1, 20'000));
}

}  // namespace
}  // namespace cosim::dda
