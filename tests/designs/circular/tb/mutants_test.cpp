// The arcs that mutants are attacked with.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tb/designs/circular/mutation/jobs.h"
#include "tests/support/designs.h"

namespace cosim::mutation {
namespace {

// Each wide pin gets each single bit, and each word that is full but for one bit, with its sign and
// without it; the other pins stay those of the arc.
TEST(CircularMutants, AreAttackedWithWordsThatAreNearlyZeroOrFull) {
  using circular::Design;
  const auto& bench = *benches_of<Design>().front();
  const std::vector<Field> pins = bench.inputs();
  std::map<std::string, std::set<Word>> seen;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const auto jobs = Jobs<Design>::random(bench.params(), campaign_seed, i);
    const Stimulus as_drawn = recorded<Design>(bench.params(), HostOf<Design>(bench.params(), jobs),
                                               static_cast<std::uint32_t>(i), disturbed_clocks);
    const Stimulus s = disturbed(bench, as_drawn, i);
    ASSERT_EQ(s.clocks.size(), as_drawn.clocks.size());
    std::set<std::size_t> changed;
    for (std::size_t clock = 0; clock < s.clocks.size(); ++clock) {
      for (std::size_t pin = 0; pin < pins.size(); ++pin) {
        if (s.clocks[clock][pin] != as_drawn.clocks[clock][pin]) changed.insert(pin);
      }
    }
    ASSERT_EQ(changed.size(), 1U) << i;
    const std::size_t pin = *changed.begin();
    for (const auto& row : s.clocks) EXPECT_EQ(row[pin], s.clocks.front()[pin]);
    seen[pins[pin].name].insert(s.clocks.front()[pin]);
  }
  EXPECT_EQ(seen["ct7"], (std::set<Word>{0b00001, 0b00010, 0b00100, 0b01000, 0b10000,  //
                                         0b11110, 0b11101, 0b11011, 0b10111, 0b01111,  //
                                         0b01110, 0b01101, 0b01011, 0b00111}));
  EXPECT_EQ(seen["ct8"], seen["ct7"]);
  EXPECT_EQ(seen["f"].size(), 6U + 6U + 5U);
  EXPECT_EQ(seen.size(), 3U);
}

}  // namespace
}  // namespace cosim::mutation
