// Sweeps on RTL other than as shipped: at the ends of the parameters' ranges that rtl/shipped.txt
// leaves out, with a fault, and as a netlist.
#include "tb/designs/linear/sweeps.h"
#include "tests/designs/linear/counts.h"
#include "tests/designs/linear/printed.h"
#include "tests/rtl/netlist.h"
#include "tests/rtl/variant_lanes.h"
#include "tests/support/sweeps.h"

namespace cosim::linear {
namespace {

TEST(Narrowest, LinearDrawsEveryLine) {
  for (const char* name : {"m2_n1", "m7_n1"}) {
    const auto& bench = *test::variant<Design>(std::string("shipped/") + name).bench;
    const auto sizes = std::uint64_t{1} << sizes_of(bench.params()).m;
    EXPECT_EQ(test::expect_match(every_line(bench)).checked.jobs, sizes * sizes);
  }
}

TEST(LinearLanesOfJobs, FindWhatOneAtATimeFinds) {
  const auto& v = test::variant<Design>("faults/rom2_entry");
  test::expect_jobs_find(v, random_lines(*v.bench, 1, 20'000));
}

TEST(LinearNetlist, MatchesOnHostileClocksAndDrawsEveryLine) {
  const auto* bench = test::netlist<Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  test::expect_match_on_hostile_clocks(*bench);
  printed::expect_table3(*bench);
  counted::expect_every_line(*bench);
}

}  // namespace
}  // namespace cosim::linear
