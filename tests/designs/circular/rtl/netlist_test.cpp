// The netlist of the circular design in the testbench.
#include "tests/rtl/netlist.h"
#include "tests/designs/circular/counts.h"
#include "tests/designs/circular/printed.h"

namespace cosim::circular {
namespace {

TEST(CircularNetlist, MatchesOnHostileClocksAndDrawsEveryArc) {
  const auto* bench = test::netlist<Design>();
  if (bench == nullptr) GTEST_SKIP() << "no yosys";
  test::expect_match_on_hostile_clocks(*bench);
  printed::expect_tables(*bench);
  counted::expect_every_start(*bench, ones(bench->params().width));
  counted::expect_every_stop(*bench, ones(bench->params().width));
}

}  // namespace
}  // namespace cosim::circular
