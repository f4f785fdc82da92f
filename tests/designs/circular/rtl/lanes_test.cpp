// Arcs in lanes on faulty RTL: each fault is found in the case, on the clock and at the signal that
// lockstep names, and what lockstep does not see is said to be an error.
#include <gtest/gtest.h>

#include "tb/designs/circular/sweeps.h"
#include "tests/rtl/variant.h"
#include "tests/support/lane_sweeps.h"

namespace cosim::circular {
namespace {

std::unique_ptr<lanes::Built> in_lanes(const test::Variant<Design>& v, const Sweep& sweep) {
  std::string id = "circular_" + v.name;
  std::replace(id.begin(), id.end(), '/', '_');
  const auto source = proof::source_in(std::filesystem::path(COSIM_VARIANTS) / id, Design::name,
                                       v.bench->parameters());
  return lanes::built_for_jobs(*v.bench, nets::played_of<Design>(v.bench->params()), source,
                               *sweep.in_lanes, 64, COSIM_LANES_FOLDER);
}

TEST(CircularLanes, FindFaultsWhereLockstepFindsThem) {
  const test::Variant<Design>*faulty = nullptr, *good = nullptr;
  const auto& all = test::variants<Design>();
  for (const auto& v : all) {
    if (v.name == "faults/two_from_one") faulty = &v;
  }
  ASSERT_TRUE(faulty);
  for (const auto& v : all) {
    if (v.name.starts_with("shipped/") && v.bench->title() == faulty->bench->title()) good = &v;
  }
  ASSERT_TRUE(good);
  Sweep sweep = random_arcs(*faulty->bench, 1, 20'000);
  const auto built = in_lanes(*faulty, sweep);
  test::expect_same_failure(*faulty->bench, sweep, *built);
  // Not in the first case, of which there are more in the lane.
  sweep = every_start(*faulty->bench, ones(faulty->bench->params().width));
  test::expect_same_failure(*faulty->bench, sweep, *built);

  sweep = random_arcs(*good->bench, 1, 20'000);
  const Sweep lanes = lanes::job_sweep(*good->bench, *built, sweep);
  EXPECT_THROW(run_sweep(lanes, 1), lanes::Unconfirmed);
}

}  // namespace
}  // namespace cosim::circular
