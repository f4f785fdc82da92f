// Lines in lanes.
#include <gtest/gtest.h>

#include "tb/designs/linear/sweeps.h"
#include "tests/support/lane_sweeps.h"

namespace cosim::linear {
namespace {

TEST(LinearLanes, SumUpToTheSweepsOfOneCaseAtATime) {
  const LinearBench& smallest = *benches_of<Design>().front();
  for (const Sweep& sweep : {every_line(smallest), random_lines(smallest, 1, 30'000)}) {
    test::expect_same_in_lanes(smallest, sweep, 64);
  }
}

}  // namespace
}  // namespace cosim::linear
