// Arcs in lanes.
#include <gtest/gtest.h>

#include "model/core/input_error.h"
#include "tb/designs/circular/figures.h"
#include "tb/designs/circular/sweeps.h"
#include "tb/sim/drawn_sweep.h"
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
  const Sweep sweep = drawn_sweep_of_one<ArcFigures>(
      smallest(), "arcs", 5000,
      [](std::uint64_t i) {
        return i == 4321 ? Arc{{9, 0}, 144, {}} : random_arc(width_of(smallest().params()), 1, i);
      },
      [](const Arc&) { return "case"; });
  const Result alone = run_sweep(sweep, 1);
  EXPECT_EQ(alone.cases, 4322U);
  EXPECT_FALSE(alone.mismatch);
  test::expect_same_failure(smallest(), sweep, *test::jobs_in_lanes(smallest(), 64));
}

// As if drivers waited for ever: a job may have no more than a clock.
class Impatient final : public LaneJobs {
 public:
  explicit Impatient(std::shared_ptr<const LaneJobs> jobs) : jobs_(std::move(jobs)) {}
  JobLayout layout() const override { return jobs_->layout(); }
  std::uint64_t cases_a_lane() const override { return 1000; }
  std::uint64_t most_clocks() const override { return 1; }
  std::unique_ptr<JobsAtWork> begin(std::size_t lanes) const override {
    return jobs_->begin(lanes);
  }

 private:
  std::shared_ptr<const LaneJobs> jobs_;
};

TEST(CircularLanes, RunACaseThatDoesNotEndAgainByItself) {
  Sweep sweep = random_arcs(smallest(), 1, 30'000);
  sweep.in_lanes = std::make_shared<Impatient>(sweep.in_lanes);
  sweep.run = [](std::uint64_t) -> Result { throw InputError("its driver waits for ever"); };
  const auto built = test::jobs_in_lanes(smallest(), 64);
  EXPECT_THROW(run_sweep(lanes::job_sweep(smallest(), *built, sweep), 1), InputError);
}

}  // namespace
}  // namespace cosim::circular
