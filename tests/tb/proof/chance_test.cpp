// Random stimuli: what is met by chance, and that what is said is so.
#include "tb/proof/chance.h"

#include <gtest/gtest.h>

#include <csignal>

#include "tb/util/interrupt.h"

namespace cosim::proof {
namespace {

using nets::Bit;
using nets::no;
using nets::yes;

// Whether all bits of a counter are 1, which counts where `goes`, and else begins anew.
Bit full(nets::Graph& graph, int bits, Bit goes) {
  Bit carry = yes;
  for (int i = 0; i < bits; ++i) {
    const Bit bit = graph.latch();
    graph.next(bit, graph.and_of(goes, graph.xor_of(bit, carry)));
    carry = graph.and_of(carry, bit);
  }
  return carry;
}

void expect_met(const nets::Graph& graph, Bit bad) {
  std::vector<std::vector<bool>> rows;
  for (std::uint64_t seed = 0; rows.empty() && seed < 16; ++seed) {
    rows = by_chance(graph, bad, seed, 10000);
  }
  ASSERT_FALSE(rows.empty());
  const auto seen = traced(graph, rows, {bad});
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_EQ(seen[i][0], i + 1 == seen.size()) << i;
}

TEST(ByChance, AnInputIsHeldForLong) {
  nets::Graph graph;
  expect_met(graph, full(graph, 12, graph.input()));
}

// And then is another: only where that is so does the second counter go.
TEST(ByChance, WhatIsHeldChangesAfterAWhile) {
  nets::Graph graph;
  const Bit stops = graph.seldom();
  const Bit first = full(graph, 12, !stops), met = graph.latch();
  graph.next(met, graph.or_of(met, first));
  expect_met(graph, full(graph, 5, graph.and_of(met, stops)));
}

TEST(ByChance, AWordIsSmall) {
  nets::Graph graph;
  Bit other = no;
  for (int i = 0; i < 96; ++i) {
    const Bit bit = graph.input("word");
    other = graph.or_of(other, i == 1 ? !bit : bit);
  }
  ASSERT_EQ(graph.words().size(), 1U);
  expect_met(graph, !other);
}

TEST(ByChance, EndsWhenItIsInterrupted) {
  nets::Graph graph;
  const Bit never = full(graph, 60, graph.input());
  const InterruptGuard interrupts;
  std::raise(SIGTERM);
  EXPECT_THROW(by_chance(graph, never, 0, ~std::size_t{0}), Interrupted);
}

TEST(ByChance, WhatCannotBeIsNot) {
  nets::Graph graph;
  const Bit a = graph.input(), b = graph.latch(true);
  graph.next(b, b);
  EXPECT_TRUE(by_chance(graph, graph.and_of(a, !b), 1, 1000).empty());
}

}  // namespace
}  // namespace cosim::proof
