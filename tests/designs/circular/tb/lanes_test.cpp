// Arcs in lanes.
#include <gtest/gtest.h>

#include "tb/designs/circular/lanes.h"
#include "tb/designs/circular/sweeps.h"
#include "tb/sweep/lane_jobs.h"
#include "tests/support/lane_sweeps.h"

namespace cosim::circular {
namespace {

const CircularBench& smallest() { return *benches_of<Design>().front(); }

TEST(CircularLanes, SumUpToTheSweepsOfOneCaseAtATime) {
  for (const int lanes : {512, 64}) {
    for (const Sweep& sweep : {every_start(smallest(), 15), every_radius(smallest(), 1, 15),
                               every_stop(smallest(), 15), random_arcs(smallest(), 1, 30'000)}) {
      test::expect_same_in_lanes(smallest(), sweep, lanes);
    }
  }
}

// The check finds wrong what RTL and model agree on: here an arc that begins off the circle.
TEST(CircularLanes, AreJudgedByTheOracle) {
  Sweep sweep = random_arcs(smallest(), 1, 5000);
  const auto arc_at = [](std::uint64_t i) {
    Arc arc = random_arc(smallest().params(), 1, i);
    if (i == 4321) arc = {{9, 0}, 144, {}};
    return arc;
  };
  sweep.run = [=](std::uint64_t i) {
    const Arc arc = arc_at(i);
    Result result = run_arcs(smallest(), {&arc, 1}, 1);
    result.failed = "case";
    return result;
  };
  sweep.in_lanes = std::make_shared<LaneJobsOf<LaneArcs>>(
      smallest().params(),
      [=](std::uint64_t i) -> std::function<bool(Arc&)> {
        return [=, is_over = false](Arc& arc) mutable {
          arc = arc_at(i);
          return !std::exchange(is_over, true);
        };
      },
      32);
  const Result alone = run_sweep(sweep, 1);
  EXPECT_EQ(alone.cases, 4322U);
  EXPECT_FALSE(alone.mismatch);
  test::expect_same_failure(smallest(), sweep, *test::jobs_in_lanes(smallest(), sweep, 64));
}

}  // namespace
}  // namespace cosim::circular
