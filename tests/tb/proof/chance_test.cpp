// Random stimuli: what is met by chance, and that what is said is so.
#include "tb/proof/chance.h"

#include <gtest/gtest.h>

#include <csignal>

#include "tb/support/interrupt.h"

namespace cosim::proof {
namespace {

using Lit = Aig::Lit;

// Whether all bits of a counter are 1, which counts where `goes`, and else begins anew.
Lit full(Aig& graph, int bits, Lit goes) {
  Lit carry = 1;
  for (int i = 0; i < bits; ++i) {
    const Lit bit = graph.latch();
    graph.next(bit, graph.and_of(goes, graph.xor_of(bit, carry)));
    carry = graph.and_of(carry, bit);
  }
  return carry;
}

void expect_met(const Aig& graph, Lit bad) {
  std::vector<std::vector<bool>> rows;
  for (std::uint64_t seed = 0; rows.empty() && seed < 16; ++seed) {
    rows = by_chance(graph, bad, seed, 10000);
  }
  ASSERT_FALSE(rows.empty());
  const auto seen = graph.run(rows, {bad});
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i][0], i + 1 == seen.size()) << i;
}

TEST(ByChance, AnInputIsHeldForLong) {
  Aig graph;
  expect_met(graph, full(graph, 12, graph.input()));
}

// And then is another: only where that is so does the second counter go.
TEST(ByChance, WhatIsHeldChangesAfterAWhile) {
  Aig graph;
  const Lit stops = graph.seldom();
  const Lit first = full(graph, 12, Aig::inverted(stops)), met = graph.latch();
  graph.next(met, graph.or_of(met, first));
  expect_met(graph, full(graph, 5, graph.and_of(met, stops)));
}

TEST(ByChance, AWordIsSmall) {
  Aig graph;
  Lit other = 0;
  for (int i = 0; i < 96; ++i) {
    const Lit bit = graph.input("word");
    other = graph.or_of(other, i == 1 ? Aig::inverted(bit) : bit);
  }
  ASSERT_EQ(graph.words().size(), 1U);
  expect_met(graph, Aig::inverted(other));
}

TEST(ByChance, EndsWhenItIsInterrupted) {
  Aig graph;
  const Lit never = full(graph, 60, graph.input());
  const InterruptGuard interrupts;
  std::raise(SIGTERM);
  EXPECT_THROW(by_chance(graph, never, 0, ~std::size_t{0}), Interrupted);
}

TEST(ByChance, WhatCannotBeIsNot) {
  Aig graph;
  const Lit a = graph.input(), b = graph.latch(true);
  graph.next(b, b);
  EXPECT_TRUE(by_chance(graph, graph.and_of(a, Aig::inverted(b)), 1, 1000).empty());
}

}  // namespace
}  // namespace cosim::proof
