// The RTL of the circular interpolator in lockstep with its model, every register and output on
// every clock, and against the oracle.
#include "tb/designs/circular/figures.h"
#include "tb/sim/drawn_sweep.h"
#include "tests/designs/circular/counts.h"
#include "tests/designs/circular/printed.h"
#include "tests/tb/shape.h"

namespace cosim::circular {
namespace {

using Param = const CircularBench*;

auto widths(int least, int most) {
  return testing::ValuesIn(test::benches_with<Design>(
      [=](const Params& p) { return width_of(p) >= least && width_of(p) <= most; }));
}

class PrintedArc : public testing::TestWithParam<Param> {};
TEST_P(PrintedArc, Tables1And2) { printed::expect_tables(*GetParam()); }
INSTANTIATE_TEST_SUITE_P(Circular, PrintedArc, widths(4, 32), test::name_of_shape<Param>);

// Up to R = 4095, or all that the width holds.
class EveryRadius : public testing::TestWithParam<Param> {};
TEST_P(EveryRadius, Matches) {
  counted::expect_every_radius(*GetParam(), ones(width_of(GetParam()->params())));
}
INSTANTIATE_TEST_SUITE_P(Circular, EveryRadius, widths(4, 12), test::name_of_shape<Param>);

class EveryStart : public testing::TestWithParam<Param> {};
TEST_P(EveryStart, Matches) {
  counted::expect_every_start(*GetParam(), ones(width_of(GetParam()->params())));
}
INSTANTIATE_TEST_SUITE_P(Circular, EveryStart, widths(4, 8), test::name_of_shape<Param>);

class EveryStop : public testing::TestWithParam<Param> {};
TEST_P(EveryStop, Matches) {
  counted::expect_every_stop(*GetParam(), std::min(ones(width_of(GetParam()->params())), Word{40}));
}
INSTANTIATE_TEST_SUITE_P(Circular, EveryStop, widths(4, 8), test::name_of_shape<Param>);

class RandomArcs : public testing::TestWithParam<Param> {};
TEST_P(RandomArcs, Match) { counted::expect_random_arcs(*GetParam(), 1, 4000); }
INSTANTIATE_TEST_SUITE_P(Circular, RandomArcs, widths(4, 32), test::name_of_shape<Param>);

// The largest quarter of the width.
class LargestQuarter : public testing::TestWithParam<Param> {};
TEST_P(LargestQuarter, Matches) {
  const std::int64_t radius = ones(width_of(GetParam()->params()));
  const std::vector<Arc> arcs = {{{radius, 0}, static_cast<std::uint64_t>(radius * radius), {}}};
  const Result result = drawn<ArcFigures, Design>(*GetParam(), arcs, 1);
  EXPECT_TRUE(result.match()) << test::explain(result);
  EXPECT_NEAR(static_cast<double>(result.checked.count("steps")),
              std::numbers::sqrt2 * static_cast<double>(radius), 2);
}
INSTANTIATE_TEST_SUITE_P(Circular, LargestQuarter, widths(4, 24), test::name_of_shape<Param>);

// The first step on the clock after the start, then one a clock; the clock between the sectors is
// the only one without, and an arc from sector 2 has none.
class OneStepAClock : public testing::TestWithParam<Param> {};
TEST_P(OneStepAClock, ButOneAtTheSectorChange) {
  const std::int64_t last = std::min(ones(width_of(GetParam()->params())), Word{40});
  for (std::int64_t radius = 1; radius <= last; ++radius) {
    const auto radius2 = static_cast<std::uint64_t>(radius * radius);
    std::vector<Arc> arcs;
    for (const Point& p : every_start(radius2)) arcs.push_back({p, radius2, {}});
    const auto clocks = test::draw(*GetParam(), std::span<const Arc>(arcs));

    std::size_t at = 0;
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      SCOPED_TRACE(testing::Message() << "R = " << radius << " from (" << arcs[i].from.x << ", "
                                      << arcs[i].from.y << ")");
      EXPECT_EQ(named<Shown>(clocks[at].outputs).running, 0);  // the start
      std::int64_t steps = 0, without = 0;
      for (++at; named<Shown>(clocks[at].outputs).running != 0; ++at) {
        ASSERT_EQ(clocks[at].job, i);
        const bool step = step_of(clocks[at].outputs) != Point{};
        ++(step ? steps : without);
        EXPECT_TRUE(step || steps > 0 || arcs[i].from.x == 0);  // the first clock has a step
      }
      ++at;
      EXPECT_EQ(steps, steps_to_end(arcs[i].from, radius2));
      EXPECT_EQ(without, (arcs[i].from.x > arcs[i].from.y) + 1);  // the change, and the end
    }
    EXPECT_EQ(at, clocks.size());
  }
}
INSTANTIATE_TEST_SUITE_P(Circular, OneStepAClock, widths(4, 32), test::name_of_shape<Param>);

}  // namespace
}  // namespace cosim::circular
