// What abc makes of gates is the same net.
#include <gtest/gtest.h>

#include "tb/lanes/code.h"
#include "tb/nets/runs.h"
#include "tb/util/process.h"
#include "tb/util/random.h"

namespace cosim::lanes {
namespace {

using nets::Bit, nets::Bits;

TEST(Mapped, IsTheSameNet) {
  if (!is_installed("yosys-abc")) GTEST_SKIP() << "needs yosys-abc";
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    nets::Graph graph;
    Bits bits{nets::no};
    for (int i = 0; i < 5; ++i) bits.push_back(graph.input());
    const Bits inputs(bits.rbegin(), bits.rend() - 1);  // in another order
    const auto any = [&] { return bits[random.below(bits.size())] ^ random.one_in_power(1); };
    for (int i = 0; i < 40; ++i) {
      const Bit a = any(), b = any(), c = any();
      const auto kind = random.below(3);
      bits.push_back(kind == 0   ? graph.and_of(a, b)
                     : kind == 1 ? graph.xor_of(a, b)
                                 : graph.mux(a, b, c));
    }
    Bits outputs;
    for (int i = 0; i < 12; ++i) outputs.push_back(any());
    const nets::Cells cells = mapped("net", graph, inputs, outputs);
    ASSERT_EQ(cells.inputs.size(), inputs.size());
    ASSERT_EQ(cells.outputs.size(), outputs.size());
    Bits made(cells.nets.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) made[cells.inputs[i]] = inputs[i];
    for (const nets::Cells::Table& t : cells.tables) {
      EXPECT_LE(t.of.size(), 3U);
      Bits of;
      for (const std::size_t net : t.of) of.push_back(made[net]);
      made[t.gives] = graph.lut(of, t.table);
    }
    const auto gates = nets::run(
        graph,
        std::vector<std::uint64_t>{0xaaaaaaaa, 0xcccccccc, 0xf0f0f0f0, 0xff00ff00, 0xffff0000});
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      EXPECT_EQ(nets::in_runs(gates, made[cells.outputs[i]]), nets::in_runs(gates, outputs[i]))
          << "seed " << seed << " output " << i;
    }
  }
}

}  // namespace
}  // namespace cosim::lanes
