// Lines and quarters in lanes.
#include <gtest/gtest.h>

#include "tb/designs/dda/sweeps.h"
#include "tests/support/lane_sweeps.h"

namespace cosim::dda {
namespace {

TEST(DdaLanes, SumUpToTheSweepsOfOneCaseAtATime) {
  const DdaBench& smallest = *benches_of<Design>().front();
  Sweep lines = every_line(smallest);
  lines.cases = 30;
  test::expect_same_in_lanes(smallest, lines, 64);
  test::expect_same_in_lanes(smallest, every_quarter(smallest), 64);
  test::expect_same_in_lanes(smallest, random_lines_and_arcs(smallest, 1, 20'000), 64);
}

}  // namespace
}  // namespace cosim::dda
