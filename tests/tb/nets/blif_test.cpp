// Gates, and what is written of them and read again, are the same.
#include "tb/nets/blif.h"

#include <gtest/gtest.h>

#include <string>

#include "model/core/input_error.h"
#include "tb/nets/runs.h"
#include "tb/util/random.h"
#include "tests/support/error_of.h"

namespace cosim::nets {
namespace {

// All runs of three inputs.
const std::vector<std::uint64_t> kThree = {0xaa, 0xcc, 0xf0};

// Of all bits there are of three inputs and the constants, every gate is what its name says.
TEST(Graph, FoldsToTheSame) {
  Graph graph;
  std::vector<Bit> bits{no, yes};
  for (int i = 0; i < 3; ++i) {
    bits.push_back(graph.input());
    bits.push_back(!bits.back());
  }
  bits.push_back(graph.and_of(bits[2], bits[4]));
  bits.push_back(!graph.mux(bits[2], bits[4], bits[6]));
  for (const Bit a : bits) {
    for (const Bit b : bits) {
      for (const Bit c : bits) {
        const Bit both = graph.and_of(a, b), either = graph.or_of(a, b),
                  differ = graph.xor_of(a, b), choice = graph.mux(a, b, c);
        const auto gates = run(graph, kThree);
        const auto of = [&](Bit bit) { return in_runs(gates, bit); };
        ASSERT_EQ(of(both), of(a) & of(b));
        ASSERT_EQ(of(either), of(a) | of(b));
        ASSERT_EQ(of(differ), of(a) ^ of(b));
        ASSERT_EQ(of(choice), (of(a) & of(b)) | (~of(a) & of(c)));
      }
    }
  }
}

TEST(Graph, HasEachGateOnce) {
  Graph graph;
  const Bit a = graph.input(), b = graph.input(), c = graph.input();
  EXPECT_EQ(graph.and_of(a, b), graph.and_of(b, a));
  EXPECT_EQ(graph.xor_of(a, !b), !graph.xor_of(b, a));
  EXPECT_EQ(graph.mux(a, b, c), graph.mux(!a, c, b));
  EXPECT_EQ(graph.mux(a, !b, !c), !graph.mux(a, b, c));
  EXPECT_EQ(graph.gates().size(), 1U + 3 + 3);
}

TEST(Graph, LooksUpEveryTableOfThree) {
  Graph graph;
  const std::vector<Bit> of{graph.input(), graph.input(), graph.input()};
  for (std::uint64_t table = 0; table < 256; ++table) {
    const Bit bit = graph.lut(of, table);
    ASSERT_EQ(in_runs(run(graph, kThree), bit) & 0xff, table);
  }
}

// A graph of random gates, of which some bits are outputs.
struct Net {
  Graph graph;
  std::vector<Port> inputs, outputs;
};
Net random_net(std::uint64_t seed) {
  Random random(seed);
  Net net;
  std::vector<Bit> bits{no};
  for (int i = 0; i < 5; ++i) {
    bits.push_back(net.graph.input());
    net.inputs.push_back({"in[" + std::to_string(i) + ']', bits.back()});
  }
  const auto any = [&] {
    const Bit bit = bits[random.below(bits.size())];
    return random.one_in_power(1) ? !bit : bit;
  };
  for (int i = 0; i < 40; ++i) {
    const Bit a = any(), b = any(), c = any();
    const auto kind = random.below(3);
    bits.push_back(kind == 0   ? net.graph.and_of(a, b)
                   : kind == 1 ? net.graph.xor_of(a, b)
                               : net.graph.mux(a, b, c));
  }
  for (std::size_t i = 0; i < 12; ++i) net.outputs.push_back({"out" + std::to_string(i), any()});
  return net;
}

TEST(Blif, ThatIsReadAgainIsTheSameNet) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Net net = random_net(seed);
    const Cells cells = read_blif(to_blif("net", net.graph, net.inputs, net.outputs), "net");
    EXPECT_EQ(cells.name, "net");
    ASSERT_EQ(cells.inputs.size(), net.inputs.size());
    ASSERT_EQ(cells.outputs.size(), net.outputs.size());
    std::vector<Bit> given(cells.nets.size());
    for (std::size_t i = 0; i < cells.inputs.size(); ++i) {
      EXPECT_EQ(cells.nets[cells.inputs[i]], net.inputs[i].name);
      given[cells.inputs[i]] = net.inputs[i].bit;
    }
    for (const Cells::Table& t : cells.tables) {
      Bits of;
      for (const std::size_t read : t.of) of.push_back(given[read]);
      given[t.gives] = net.graph.lut(of, t.table);
    }
    const auto gates = run(net.graph, std::vector<std::uint64_t>{0xaaaaaaaa, 0xcccccccc, 0xf0f0f0f0,
                                                                 0xff00ff00, 0xffff0000});
    for (std::size_t i = 0; i < cells.outputs.size(); ++i) {
      ASSERT_EQ(in_runs(gates, given[cells.outputs[i]]), in_runs(gates, net.outputs[i].bit))
          << "seed " << seed << " output " << i;
    }
  }
}

TEST(Blif, IsReadAsToolsWriteIt) {
  const Cells cells = read_blif(
      "# a comment\n.model top\n.inputs a b \\\n  clk\n.outputs y\n"
      ".names $false\n.names $true\n1\n"
      ".names m b y # of what stands below\n11 1\n"
      ".names a b m\n00 0\n11 0\n"
      ".end\n",
      "top.blif");
  EXPECT_EQ(cells.inputs.size(), 3U);
  const auto named = [&](std::size_t net) { return cells.nets[net]; };
  ASSERT_EQ(cells.tables.size(), 4U);
  EXPECT_EQ(cells.tables[0].table, 0U);
  EXPECT_EQ(cells.tables[1].table, 1U);
  EXPECT_EQ(named(cells.tables[2].gives), "m");
  EXPECT_EQ(cells.tables[2].table, 6U);  // where a and b differ
  EXPECT_EQ(named(cells.tables[3].gives), "y");
  EXPECT_EQ(cells.tables[3].table, 8U);
}

std::string refusal(const std::string& text) {
  return test::error_of([&] { read_blif(text, "x.blif"); });
}
TEST(Blif, ThatIsNoneIsRefused) {
  EXPECT_EQ(refusal(".inputs a b c d e f g\n.names a b c d e f g y\n"),
            "x.blif: line 2: net y: a table of 7 inputs, more than 6");
  EXPECT_EQ(refusal(".names y\n.names y\n"), "x.blif: line 2: net y: two things drive it");
  EXPECT_EQ(refusal(".names a y\n1 1\n"), "x.blif: net a: nothing drives it");
  EXPECT_EQ(refusal(".names a b\n1 1\n.names b a\n1 1\n"), "x.blif: net b: a loop");
  EXPECT_EQ(refusal(".inputs a\n.names a y\n11 1\n"), "x.blif: line 3: not a row of this table");
  EXPECT_EQ(refusal(".inputs a\n.names a y\n1 1\n0 0\n"),
            "x.blif: line 4: not a row of this table");
  EXPECT_EQ(refusal("1 1\n"), "x.blif: line 1: 1: not in a table");
  EXPECT_EQ(refusal(".subckt adder A=x\n"),
            "x.blif: line 1: .subckt adder A=x: not a netlist of tables");
  EXPECT_EQ(refusal(".latch a b\n"), "x.blif: line 1: .latch a b: not a netlist of tables");
  EXPECT_EQ(refusal(".model a\n.model b\n"), "x.blif: line 2: a second model");

  Graph graph;
  const Bit a = graph.input();
  EXPECT_THROW(to_blif("net", graph, {}, {{"y", a}}), InputError);
}

}  // namespace
}  // namespace cosim::nets
