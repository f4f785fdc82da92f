// Planes against 64 runs of the same graph, gate by gate.
#include "tb/nets/planes.h"

#include <gtest/gtest.h>

#include "tb/nets/runs.h"
#include "tb/util/random.h"

namespace cosim::test {
namespace {

using nets::Bit, nets::Plane;

// Each gate from bits at random, any of them opposite.
nets::Graph made_at_random(Random& random, std::vector<Bit>& bits) {
  nets::Graph graph;
  bits = {nets::no};
  for (int i = 0; i < 20; ++i) bits.push_back(graph.input());
  const auto any = [&] {
    const Bit bit = bits[random.below(bits.size())];
    return random.below(2) == 0 ? bit : !bit;
  };
  for (int i = 0; i < 500; ++i) {
    switch (random.below(3)) {
      case 0:
        bits.push_back(graph.and_of(any(), any()));
        break;
      case 1:
        bits.push_back(graph.xor_of(any(), any()));
        break;
      default:
        bits.push_back(graph.mux(any(), any(), any()));
    }
  }
  return graph;
}

// What each of these inputs is given.
std::vector<Plane> given_at_random(Random& random, nets::Planes& planes,
                                   const std::vector<Bit>& inputs) {
  std::vector<Plane> given(inputs.size());
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    for (std::uint64_t& w : given[i].words) w = random.next();
    planes.give(inputs[i], given[i]);
  }
  return given;
}

TEST(Planes, HoldWhatSixtyFourRunsGive) {
  Random random(3);
  for (const std::size_t lanes : {std::size_t{64}, nets::plane_lanes}) {
    std::vector<Bit> bits;
    const nets::Graph graph = made_at_random(random, bits);
    nets::Planes planes(graph, bits, lanes);
    const auto given = given_at_random(random, planes, graph.inputs());
    planes.run();
    for (std::size_t w = 0; w < lanes / 64; ++w) {
      std::vector<std::uint64_t> inputs;
      for (const Plane& p : given) inputs.push_back(p.words[w]);
      const auto gates = run(graph, inputs);
      for (const Bit bit : bits) {
        ASSERT_EQ(planes.get(bit).words[w], in_runs(gates, bit));
        ASSERT_EQ(planes.get(!bit).words[w], in_runs(gates, !bit));
      }
    }
  }
}

// Shift registers, in which each takes what another holds: all at once, in their own lanes only.
TEST(Planes, TakeTheNextAtAnEdge) {
  Random random(4);
  for (const std::size_t lanes : {std::size_t{64}, nets::plane_lanes}) {
    nets::Graph graph;
    const std::vector<Bit> held{graph.input(), graph.input(), graph.input()};
    nets::Planes planes(graph, held, lanes);
    const auto before = given_at_random(random, planes, held);
    std::vector<Plane> taking(held.size());
    std::vector<nets::PlaneFlipFlop> flip_flops;
    for (std::size_t i = 0; i < held.size(); ++i) {
      for (std::uint64_t& w : taking[i].words) w = random.next();
      flip_flops.push_back(planes.flip_flop(held[i], !held[(i + 1) % held.size()], taking[i]));
    }
    planes.run();
    planes.edge(flip_flops);
    for (std::size_t i = 0; i < held.size(); ++i) {
      const Plane after = planes.get(held[i]);
      for (std::size_t l = 0; l < lanes; ++l) {
        const bool next = !before[(i + 1) % held.size()].lane(l);
        ASSERT_EQ(after.lane(l), taking[i].lane(l) ? next : before[i].lane(l));
      }
    }
  }
}

TEST(Planes, DifferWhereOneOfTheBitsDoes) {
  Random random(5);
  for (const std::size_t lanes : {std::size_t{64}, nets::plane_lanes}) {
    nets::Graph graph;
    const std::vector<Bit> bits{graph.input(), graph.input(), graph.input()};
    nets::Planes planes(graph, bits, lanes);
    const auto given = given_at_random(random, planes, bits);
    const std::vector<nets::PlaneRoot> roots{planes.root(bits[0]), planes.root(!bits[1]),
                                             planes.root(bits[2])};
    for (Word value = 0; value < 8; ++value) {
      const Plane differing = planes.differing(roots, value);
      for (std::size_t l = 0; l < lanes; ++l) {
        const Word is = given[0].lane(l) + 2 * !given[1].lane(l) + 4 * given[2].lane(l);
        ASSERT_EQ(differing.lane(l), is != value);
      }
    }
  }
}

}  // namespace
}  // namespace cosim::test
