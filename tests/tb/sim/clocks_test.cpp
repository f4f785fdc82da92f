// Several clocks in hostile stimulus: each set of them takes its edge, in all the ways that clocks
// have.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "model/clocked/design.h"
#include "model/core/reset.h"
#include "tb/sim/hostile.h"
#include "tests/examples/designs/domains.h"

namespace cosim::test {

// What CMake would know of the design.
struct DomainsSays {
  static constexpr const char* name = "domains";
  static constexpr std::array<std::array<Parameter, 0>, 1> parameters{};
  static constexpr std::array files{""};
};

namespace {

using Design = clocked::DesignOf<DomainsSays, Domains<0>>;
template <class V>
using Inputs = Design::Inputs<V>;

TEST(Clocks, AllTakeTheirEdgeWhereTheDesignRestsOrIsCleared) {
  static_assert(clocks_of<Design> == 2);
  EXPECT_EQ(to_words(rest_of<Design>()), (Words<Inputs<Word>>{1, 0, 0, 1, 1}));
  EXPECT_EQ(to_words(reset_inputs_of<Design>()), (Words<Inputs<Word>>{1, 1, 0, 1, 0}));
}

TEST(Clocks, AreDrawnAsClocksRun) {
  std::array<int, 4> sets{};  // of both, how often
  int still = 0,
      by_turns = 0;          // the longest rows: one stands still and the other does not; 0 1 0 1
  int idle = 0;              // stretches in which nothing moves
  int rare = 0, on_end = 0;  // stretches with few edges; the longest row of edges among others
  for (std::uint64_t index = 0; index < 200; ++index) {
    HostileStimulus<Design> hostile(Design::Params{}, {7, index, 1024});
    int row = 0, turns = 0, edges = 0, any = 0, together = 0, clock = 0;
    Word last = 0;
    for (Inputs<Word> inputs; hostile.next(inputs, {}); ++clock) {
      const auto in = clocked::object_of<Domains<0>::In>(inputs);
      const Word a = in.a_clk ? 1 : 0, b = in.b_clk ? 1 : 0;
      ++sets[static_cast<std::size_t>(2 * a + b)];
      row = a == 0 ? row + static_cast<int>(b) : 0;
      turns = a != last ? turns + 1 : 0;
      if (a == 0 && together < 100) on_end = std::max(on_end, together);
      together = a != 0 ? together + 1 : 0;
      still = std::max(still, row);
      by_turns = std::max(by_turns, turns);
      last = a;
      edges += static_cast<int>(a);
      any += static_cast<int>(a | b);
      if (clock % 256 == 255) {
        rare += edges > 0 && edges < 32 ? 1 : 0;
        idle += any == 0 ? 1 : 0;
        edges = any = 0;
      }
    }
  }
  for (const int each : sets) EXPECT_GT(each, 10000);
  EXPECT_LT(idle, 12);  // of 800 stretches
  EXPECT_GT(still, 200);
  EXPECT_GT(by_turns, 200);
  EXPECT_GT(rare, 20);
  EXPECT_GT(on_end, 20);
}

}  // namespace
}  // namespace cosim::test
