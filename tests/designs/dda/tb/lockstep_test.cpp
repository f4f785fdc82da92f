// The RTL of the DDA in lockstep with its model, every register and output on every clock, and
// against the oracle.
#include <gtest/gtest.h>

#include "tb/designs/dda/sweeps.h"
#include "tests/designs/dda/flow_chart.h"
#include "tests/designs/dda/runs.h"
#include "tests/support/lane_sweeps.h"
#include "tests/support/sweeps.h"
#include "tests/tb/shape.h"

namespace cosim::dda {
namespace {

using Param = const DdaBench*;

auto widths(int least, int most) {
  return testing::ValuesIn(test::benches_with<Design>(
      [=](const Params& p) { return width_of(p) >= least && width_of(p) <= most; }));
}

class EveryDdaLine : public testing::TestWithParam<Param> {};
TEST_P(EveryDdaLine, Matches) {
  const Result result = test::expect_match(every_line(*GetParam()));
  const auto side = static_cast<std::uint64_t>(2 * ones(width_of(GetParam()->params())) + 1);
  EXPECT_EQ(result.checked.jobs, 8 * side * side);
  EXPECT_LT(result.checked.number("max_deviation"), 1);
}
INSTANTIATE_TEST_SUITE_P(Dda, EveryDdaLine, widths(6, 6), test::name_of_shape<Param>);

class EveryQuarter : public testing::TestWithParam<Param> {};
TEST_P(EveryQuarter, Matches) {
  const Result result = test::expect_match(every_quarter(*GetParam()));
  EXPECT_EQ(result.checked.jobs,
            static_cast<std::uint64_t>(4 * ones(width_of(GetParam()->params()))));
}
TEST_P(EveryQuarter, IsThatOfTheFlowChart) {
  const int width = width_of(GetParam()->params());
  for (std::int64_t radius = 1; radius <= ones(width); radius += 11) {
    for (const Settings& settings : kEverySettings) {
      ASSERT_EQ(points(*GetParam(), arc(width, {radius, 0}, {0, radius}, settings)),
                flow_chart::quarter(width, radius, settings));
    }
  }
}
INSTANTIATE_TEST_SUITE_P(Dda, EveryQuarter, widths(6, 8), test::name_of_shape<Param>);

class RandomCurves : public testing::TestWithParam<Param> {};
TEST_P(RandomCurves, Match) {
  const Result result = test::expect_match(random_jobs(*GetParam(), 1, 4000));
  EXPECT_EQ(result.checked.jobs, 4000U);
}
INSTANTIATE_TEST_SUITE_P(Dda, RandomCurves, widths(2, 32), test::name_of_shape<Param>);

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
