// Invariants that a SAT solver has seen: what is said never to happen does not.
#include "tb/proof/invariant.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "tb/nets/runs.h"
#include "tb/util/random.h"
#include "tests/support/stand_ins.h"

namespace cosim::proof {
namespace {

using nets::Bit;
using nets::no;
using nets::yes;

Invariant soon(const nets::Graph& graph, Bit bad) {
  return invariant_of(graph, bad, std::chrono::steady_clock::now() + std::chrono::minutes(5));
}

struct Machine {
  nets::Graph graph;
  Bit bad = no;
};

// Registers and inputs in gates by chance.
Machine machine(std::uint64_t seed) {
  constexpr int latches = 5, inputs = 2, gates = 16;
  Random random(seed);
  Machine m;
  nets::Bits all, registers;
  for (int i = 0; i < latches; ++i) registers.push_back(m.graph.latch(random.below(2) == 1));
  all = registers;
  for (int i = 0; i < inputs; ++i) all.push_back(m.graph.input());
  const auto any = [&] { return all[random.below(all.size())] ^ (random.below(2) == 1); };
  for (int i = 0; i < gates; ++i) {
    const auto kind = random.below(4);
    all.push_back(kind == 0   ? m.graph.xor_of(any(), any())
                  : kind == 1 ? m.graph.mux(any(), any(), any())
                              : m.graph.and_of(any(), any()));
  }
  for (const Bit latch : registers) m.graph.next(latch, any());
  m.bad = m.graph.and_of(any(), m.graph.and_of(any(), any()));
  return m;
}

// Whether it is ever so, by trying all inputs in all states that are reached.
bool happens(const Machine& m) {
  const std::vector<nets::Graph::Latch>& latches = m.graph.latches();
  std::vector<bool> first;
  for (const nets::Graph::Latch& latch : latches) first.push_back(latch.first);
  std::set<std::vector<bool>> met{first};
  for (std::vector<std::vector<bool>> open{first}; !open.empty();) {
    std::vector<std::uint64_t> state;
    for (const bool bit : open.back()) state.push_back(bit ? ~std::uint64_t{0} : 0);
    open.pop_back();
    nets::Runs runs(m.graph);
    runs.begin(state);
    runs.clock(std::array<std::uint64_t, 2>{0b1100, 0b1010});  // the four that two inputs have
    if ((runs.of(m.bad) & 0xfU) != 0) return true;
    for (unsigned i = 0; i < 4; ++i) {
      std::vector<bool> next;
      for (const nets::Graph::Latch& latch : latches)
        next.push_back(((runs.of(latch.next) >> i) & 1) != 0);
      if (met.insert(next).second) open.push_back(next);
    }
  }
  return false;
}

TEST(Invariant, IsThereWhereItNeverHappensAndElseNot) {
  int never = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const Machine m = machine(seed);
    if (m.bad == no) continue;
    const bool is = happens(m);
    EXPECT_EQ(!soon(m.graph, m.bad).is_checked, is) << seed;
    never += is ? 0 : 1;
  }
  EXPECT_GT(never, 3);
  EXPECT_LT(never, 9);
}

TEST(Invariant, OfEqualSignalsAndOfClauses) {
  // Two of three registers in a ring, of which one is 1, are never 1; the third is there twice.
  nets::Graph graph;
  const Bit goes = graph.input(), a = graph.latch(true), b = graph.latch(), c = graph.latch(),
            again = graph.latch();
  graph.next(a, graph.mux(goes, c, a));
  graph.next(b, graph.mux(goes, a, b));
  graph.next(c, graph.mux(goes, b, c));
  graph.next(again, graph.or_of(graph.and_of(goes, b), graph.and_of(!goes, again)));
  const Invariant of_clauses = soon(graph, graph.and_of(a, c));
  EXPECT_TRUE(of_clauses.is_checked);
  EXPECT_GT(of_clauses.clauses, 0U);
  const Invariant of_equalities = soon(graph, graph.xor_of(c, again));
  EXPECT_TRUE(of_equalities.is_checked);
  EXPECT_GT(of_equalities.equalities, 0U);
  EXPECT_EQ(of_equalities.clauses, 0U);
}

// Runs by chance do not come to it, and no other engine does in that time.
TEST(Invariant, IsNotWhatHoldsForLong) {
  nets::Graph graph;
  Bit carry = yes;
  for (int i = 0; i < 20; ++i) {
    const Bit bit = graph.latch();
    graph.next(bit, graph.xor_of(bit, carry));
    carry = graph.and_of(carry, bit);
  }
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
  EXPECT_FALSE(invariant_of(graph, carry, until).is_checked);
}

// What another program gives for one is looked at.
TEST(Invariant, ThatIsNoneIsNotTaken) {
  const test::StandIns bin{};
  bin.program("yosys-abc", "printf '.ilb r0\\n.ob inv\\n%s 1\\n' $SAID > invariant");
  nets::Graph graph;
  const Bit sets = graph.input(), latch = graph.latch();
  graph.next(latch, graph.or_of(latch, sets));
  setenv("SAID", "1", 1);  // never set: it is so at first, but is left
  EXPECT_FALSE(soon(graph, latch).is_checked);
  setenv("SAID", "0", 1);  // never 0: that is never left, but it is not so at first
  EXPECT_FALSE(soon(graph, graph.and_of(sets, !latch)).is_checked);
  unsetenv("SAID");
}

}  // namespace
}  // namespace cosim::proof
