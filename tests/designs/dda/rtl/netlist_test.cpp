// The netlist of the dda design in the testbench.
#include "tests/rtl/netlist.h"
#include "tb/designs/dda/sweeps.h"

namespace cosim::dda {
namespace {

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
