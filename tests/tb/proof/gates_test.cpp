// What cells of yosys come to as gates.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <map>
#include <optional>

#include "tb/proof/rtl_nets.h"
#include "tb/util/process.h"

namespace cosim::proof {
namespace {

// An output of RTL with these inputs, lowest bits first: a of 5 bits and b of 3 with a sign, c of 5
// and d of 3 without.
class Operators {
 public:
  explicit Operators(const std::string& assigned) {
    const Scratch scratch;
    const auto file = scratch.path() / "top.v";
    std::ofstream(file) << "module top(input clk, input signed [4:0] a, input signed [2:0] b,\n"
                           "  input [4:0] c, input [2:0] d, output [6:0] y);\n"
                        << "assign y = " << assigned << ";\nendmodule\n";
    rtl_.emplace(Source{{file}, "top", {}});
  }
  std::uint64_t at(unsigned wide, unsigned narrow) const {
    nets::Graph graph;
    std::map<std::size_t, nets::Bit> given;
    for (const nets::Bit pin : rtl_->pins()) given[pin.gate()] = nets::no;
    const auto give = [&](const char* name, int width, unsigned code) {
      for (int i = 0; i < width; ++i) {
        given[rtl_->net(name, i).gate()] = nets::constant((code >> i & 1U) != 0);
      }
    };
    give("a", 5, wide);
    give("c", 5, wide);
    give("b", 3, narrow);
    give("d", 3, narrow);
    const auto all = placed(graph, rtl_->graph(), given);
    std::uint64_t y = 0;
    for (int i = 0; i < 7; ++i)
      y |= std::uint64_t{placed_at(all, rtl_->net("y", i)) == nets::yes} << i;
    return y;
  }

 private:
  std::optional<RtlNets> rtl_;
};

TEST(Gates, AddAndCompareAsVerilogDoes) {
  if (!is_installed("yosys")) GTEST_SKIP() << "needs yosys";
  struct Case {
    const char* rtl;
    std::function<int(int a, int b, int c, int d)> is;
  };
  const std::vector<Case> cases = {
      {"a + b", [](int a, int b, int, int) { return a + b; }},
      {"a - b", [](int a, int b, int, int) { return a - b; }},
      {"b - a", [](int a, int b, int, int) { return b - a; }},
      {"c + d", [](int, int, int c, int d) { return c + d; }},
      {"d - c", [](int, int, int c, int d) { return d - c; }},
      {"a + d", [](int, int, int c, int d) { return c + d; }},  // one without a sign: both are
      {"{a < b, a <= b, a > b, a >= b}",
       [](int a, int b, int, int) { return (a < b) * 8 + (a <= b) * 4 + (a > b) * 2 + (a >= b); }},
      {"{c < d, c <= d, c > d, c >= d}",
       [](int, int, int c, int d) { return (c < d) * 8 + (c <= d) * 4 + (c > d) * 2 + (c >= d); }},
      {"{b < d, d <= b}",  // likewise
       [](int, int b, int, int d) { return ((b & 7) < d) * 2 + (d <= (b & 7)); }}};
  for (const Case& c : cases) {
    const Operators rtl(c.rtl);
    for (int wide = 0; wide < 32; ++wide) {
      for (int narrow = 0; narrow < 8; ++narrow) {
        const int a = wide < 16 ? wide : wide - 32, b = narrow < 4 ? narrow : narrow - 8;
        ASSERT_EQ(rtl.at(static_cast<unsigned>(wide), static_cast<unsigned>(narrow)),
                  static_cast<unsigned>(c.is(a, b, wide, narrow)) & 127U)
            << c.rtl << ' ' << wide << ' ' << narrow;
      }
    }
  }
}

}  // namespace
}  // namespace cosim::proof
