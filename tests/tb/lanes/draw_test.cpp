// Hostile stimulus as gates: 64 cases at once draw what each draws alone.
#include "tb/nets/draw.h"

#include <gtest/gtest.h>

#include <vector>

#include "tb/nets/runs.h"
#include "tb/sim/hostile.h"
#include "tests/support/shapes.h"

namespace cosim::test {
namespace {

using Runs = std::vector<std::uint64_t>;

// What a step makes of 64 cases, which begin with `held`.
Runs stepped(const nets::DrawStep& step, const std::vector<nets::Bit>& wanted, const Runs& held) {
  const Runs gates = run(step.graph, held);
  Runs bits;
  for (const nets::Bit bit : wanted) bits.push_back(in_runs(gates, bit));
  return bits;
}

template <class Design>
void expect_drawn(const typename Design::Params& p) {
  using Inputs = typename Design::template Inputs<Word>;
  constexpr std::uint64_t seed = 3, first = 1000, clocks = 2 * HostileCase::stretch + 50;
  const auto fields = Inputs::fields(p);
  const nets::Draw draw = nets::draw_of<Design>(p);
  Runs held(draw.clock.held.size());
  std::vector<HostileStimulus<Design>> alone;
  for (std::uint64_t lane = 0; lane < 64; ++lane) {
    const HostileCase c{seed, first + lane, clocks};
    alone.emplace_back(p, c);
    std::size_t at = 0;
    c.seeds(draw.seeds, [&](std::uint64_t word) {
      for (int b = 0; b < 64; ++b) held[at++] |= (word >> b & 1) << lane;
    });
  }
  for (std::uint64_t clock = 0; clock < clocks; ++clock) {
    if (clock % HostileCase::stretch == 0) held = stepped(draw.stretch, draw.stretch.after, held);
    const Runs drawn = stepped(draw.clock, draw.clock.inputs, held);
    held = stepped(draw.clock, draw.clock.after, held);
    for (std::size_t lane = 0; lane < 64; ++lane) {
      Inputs in;
      ASSERT_TRUE(alone[lane].next(in, {}));
      const auto words = to_words(in);
      std::size_t at = 0;
      for (std::size_t i = 0; i < fields.size(); ++i) {
        for (int b = 0; b < fields[i].width; ++b, ++at) {
          ASSERT_EQ(drawn[at] >> lane & 1, bit(words[i], b) ? 1U : 0U)
              << fields[i].name << " bit " << b << ", case " << lane << ", clock " << clock;
        }
      }
    }
  }
}

template <class Design>
class DrawOf : public testing::Test {};
TYPED_TEST_SUITE(DrawOf, Designs, DesignNames);

TYPED_TEST(DrawOf, IsTheStimulusOfEachCase) { for_each_shape<TypeParam>(expect_drawn<TypeParam>); }

}  // namespace
}  // namespace cosim::test
