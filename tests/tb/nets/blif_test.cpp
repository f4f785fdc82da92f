// Gates are what their names say, and netlists of tables are read as abc writes them.
#include "tb/nets/blif.h"

#include <gtest/gtest.h>

#include <string>

#include "tb/nets/runs.h"
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
}

}  // namespace
}  // namespace cosim::nets
