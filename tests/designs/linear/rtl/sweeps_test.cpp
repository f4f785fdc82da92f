// Sweeps on RTL at the ends of the parameters' ranges that rtl/shipped.txt leaves out, and on RTL
// with a fault.
#include "tb/designs/linear/sweeps.h"
#include "tests/rtl/variant_lanes.h"
#include "tests/support/sweeps.h"

namespace cosim::linear {
namespace {

TEST(Narrowest, LinearDrawsEveryLine) {
  for (const char* name : {"m2_n1", "m7_n1"}) {
    const auto& bench = *test::variant<Design>(std::string("shipped/") + name).bench;
    const auto sizes = std::uint64_t{1} << bench.params().m;
    EXPECT_EQ(test::expect_match(every_line(bench)).checked.jobs, sizes * sizes);
  }
}

TEST(LinearLanesOfJobs, FindWhatOneAtATimeFinds) {
  const auto& v = test::variant<Design>("faults/rom2_entry");
  test::expect_jobs_find(v, random_lines(*v.bench, 1, 20'000));
}

}  // namespace
}  // namespace cosim::linear
