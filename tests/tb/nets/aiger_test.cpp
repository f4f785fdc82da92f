// Graphs as AIGER: read back here, they give what they give as graphs.
#include <gtest/gtest.h>

#include <sstream>

#include "tb/nets/runs.h"
#include "tb/util/random.h"

namespace cosim::nets {
namespace {

using Runs64 = std::uint64_t;

// What the one output gives where the inputs and, behind them, the latches are these; what the
// latches hold next follows it.
std::vector<Runs64> outputs_of(const std::string& file, const std::vector<Runs64>& leaves) {
  std::istringstream in(file);
  std::string kind;
  std::size_t last = 0, inputs = 0, latches = 0, outputs = 0, gates = 0;
  in >> kind >> last >> inputs >> latches >> outputs >> gates;
  std::vector<std::size_t> next(latches), all(outputs);
  for (std::size_t& literal : next) in >> literal;
  for (std::size_t& literal : all) in >> literal;
  in.get();
  std::vector<Runs64> values{0};
  values.insert(values.end(), leaves.begin(), leaves.end());
  const auto of = [&](std::size_t literal) {
    return values.at(literal / 2) ^ (literal % 2 == 0 ? 0 : ~Runs64{0});
  };
  const auto delta = [&] {
    std::size_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
      const auto byte = static_cast<unsigned>(in.get());
      value |= std::size_t{byte & 0x7fU} << shift;
      if (byte < 0x80) return value;
    }
  };
  for (std::size_t i = 0; i < gates; ++i) {
    const std::size_t high = 2 * values.size() - delta(), low = high - delta();
    values.push_back(of(high) & of(low));
  }
  EXPECT_EQ(values.size(), last + 1);
  std::vector<Runs64> given{of(all.at(0))};
  for (const std::size_t literal : next) given.push_back(of(literal));
  return given;
}

TEST(Aiger, GivesWhatTheGraphGives) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    Random random = Random::for_case(seed, 0);
    Graph graph;
    Bits all{yes};
    for (int i = 0; i < 4; ++i) all.push_back(graph.input());
    for (int i = 0; i < 3; ++i) all.push_back(graph.latch(random.below(2) == 1));
    const auto any = [&] { return all[random.below(all.size())] ^ (random.below(2) == 1); };
    for (int i = 0; i < 20; ++i) {
      const auto kind = random.below(3);
      all.push_back(kind == 0   ? graph.xor_of(any(), any())
                    : kind == 1 ? graph.mux(any(), any(), any())
                                : graph.and_of(any(), any()));
    }
    for (const Graph::Latch& latch : std::vector(graph.latches())) graph.next(latch.now, any());
    const Bit bad = any();

    std::vector<Runs64> leaves;
    for (int i = 0; i < 7; ++i) leaves.push_back(random.next());
    const std::vector<Runs64> inputs(leaves.begin(), leaves.begin() + 4);
    const std::vector<Runs64> state(leaves.begin() + 4, leaves.end());
    const auto gates = run(graph, inputs, state);
    std::vector<Runs64> expected{in_runs(gates, bad)};
    // One that begins as 1 is kept inverted.
    for (std::size_t i = 0; i < state.size(); ++i) {
      const Runs64 turned = graph.latches()[i].first ? ~Runs64{0} : 0;
      leaves[4 + i] ^= turned;
      expected.push_back(in_runs(gates, graph.latches()[i].next) ^ turned);
    }
    EXPECT_EQ(outputs_of(aiger(graph, {bad}), leaves), expected) << seed;
  }
}

TEST(Aiger, NamesWhatItIsGivenNamesFor) {
  Graph graph;
  const Bit a = graph.input(), b = graph.input(), held = graph.latch();
  graph.next(held, a);
  const std::string file = aiger(graph, {graph.and_of(b, held)}, {{b.gate(), "count[3]"}});
  EXPECT_TRUE(file.ends_with("i0 p0\ni1 count[3]\nl0 r0\n")) << file;
}

}  // namespace
}  // namespace cosim::nets
