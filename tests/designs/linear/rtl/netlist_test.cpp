// The netlist of the linear design in the testbench.
#include "tests/rtl/netlist.h"
#include "tests/designs/linear/counts.h"
#include "tests/designs/linear/printed.h"

namespace cosim::linear {
namespace {

TEST(LinearNetlist, MatchesOnHostileClocksAndDrawsEveryLine) {
  const auto* bench = test::netlist<Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  test::expect_match_on_hostile_clocks(*bench);
  printed::expect_table3(*bench);
  counted::expect_every_line(*bench);
}

}  // namespace
}  // namespace cosim::linear
