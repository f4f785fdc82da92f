// What gates can be from reset on, by ternary simulation.
#include "tb/nets/possible.h"

#include <gtest/gtest.h>

#include <random>

#include "tb/nets/runs.h"

namespace cosim::nets {
namespace {

TEST(Possible, ARegisterThatOnlyKeepsItsValueIsConstant) {
  Graph graph;
  const Bit in = graph.input(), low = graph.latch(), high = graph.latch(true), any = graph.latch();
  graph.next(low, graph.and_of(low, in));
  graph.next(high, graph.or_of(high, in));
  graph.next(any, graph.xor_of(low, in));
  const auto values = possible(graph);
  EXPECT_TRUE(values[low.gate()].zero);
  EXPECT_FALSE(values[low.gate()].one);
  EXPECT_FALSE(values[high.gate()].zero);
  EXPECT_TRUE(values[high.gate()].one);
  EXPECT_TRUE(values[any.gate()].zero);
  EXPECT_TRUE(values[any.gate()].one);
}

// Whatever happens in random runs of random graphs is possible.
TEST(Possible, NothingThatHappensIsLeftOut) {
  std::mt19937 random(1);
  for (int graphs = 0; graphs < 200; ++graphs) {
    Graph graph;
    Bits all{no, yes, graph.input(), graph.input()}, latches;
    for (int i = 0; i < 6; ++i) latches.push_back(graph.latch(random() % 2 != 0));
    all.insert(all.end(), latches.begin(), latches.end());
    const auto any = [&] { return all[random() % all.size()] ^ (random() % 2 != 0); };
    for (int i = 0; i < 30; ++i) {
      const Bit a = any(), b = any(), c = any();
      all.push_back(i % 3 == 0   ? graph.and_of(a, b)
                    : i % 3 == 1 ? graph.xor_of(a, b)
                                 : graph.mux(a, b, c));
    }
    for (const Bit latch : latches) graph.next(latch, any());
    const auto values = possible(graph);
    Runs runs(graph);
    for (int clock = 0; clock < 20; ++clock) {
      const std::uint64_t inputs[] = {random(), random()};
      runs.clock(inputs);
      for (const Bit bit : all) {
        const MayBe may = values[bit.gate()].inverted(bit.is_inverted());
        ASSERT_TRUE(may.one || runs.of(bit) == 0) << bit.code;
        ASSERT_TRUE(may.zero || runs.of(bit) == ~std::uint64_t{0}) << bit.code;
      }
    }
  }
}

}  // namespace
}  // namespace cosim::nets
