// Questions about gates, and what the engines say of them.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <filesystem>

#include "tb/nets/number.h"
#include "tb/nets/runs.h"
#include "tb/proof/engines.h"
#include "tb/proof/rtl_nets.h"
#include "tests/support/solvers.h"
#include "tests/support/stand_ins.h"

namespace cosim::proof {
namespace {

using nets::Bit, test::kLimit;

// Whether the product of two numbers of two bits can be 7, 9 or 5, and they then.
Questions products() {
  Questions q;
  const auto number = [&](const char* name) {
    std::vector<Bit> code;
    for (int i = 0; i < 2; ++i) {
      code.push_back(q.graph.input());
      q.inputs.push_back({std::string(name) + std::to_string(i), code.back()});
    }
    q.terms[name] = code;
    return nets::Number::unsigned_code(q.graph, code);
  };
  const nets::Number a = number("a"), b = number("b");
  const auto ask = [&](Word product) {
    q.asked.push_back({std::to_string(product), (a * b == nets::Number(product)).bit()});
  };
  ask(7);
  ask(9);
  ask(5);
  return q;
}

TEST(Engines, AnswerEachQuestionAndSayWhen) {
  if (!test::can_prove()) GTEST_SKIP() << "needs yosys";
  for (const Engine engine : all_engines()) {
    const Solved solved = solve(engine, products(), kLimit);
    EXPECT_EQ(solved.answers, (std::vector{Answer::unsat, Answer::sat, Answer::unsat}))
        << solved.said;
    EXPECT_EQ(solved.answer, Answer::unsat);
    EXPECT_EQ(solved.values.at("a"), 3);
    EXPECT_EQ(solved.values.at("b"), 3);
  }
}

// Whether a prime of 61 bits is a product of two numbers of so many bits: no engine knows soon.
Questions factors(int bits) {
  Questions q;
  const auto number = [&](const std::string& name) {
    std::vector<Bit> code;
    for (int i = 0; i < bits; ++i) {
      code.push_back(q.graph.input());
      q.inputs.push_back({name + std::to_string(i), code.back()});
    }
    return nets::Number::unsigned_code(q.graph, code);
  };
  const nets::Number a = number("a"), b = number("b");
  const Word prime = (Word{1} << 61) - 1;
  const auto more_than_one = [](const nets::Number& n) { return n > nets::Number(1); };
  q.asked.push_back(
      {"factors", ((a * b == nets::Number(prime)) & more_than_one(a) & more_than_one(b)).bit()});
  return q;
}
TEST(Engines, AreStoppedAtTheirLimitOrWhereNoMoreIsWanted) {
  if (!test::can_prove()) GTEST_SKIP() << "needs yosys";
  const std::atomic<bool> no_more = true;
  for (const Engine engine : all_engines()) {
    EXPECT_EQ(solve(engine, factors(31), 1).answer, Answer::timed_out) << to_text(engine);
    EXPECT_EQ(solve(engine, factors(31), kLimit, &no_more).answer, Answer::stopped)
        << to_text(engine);
  }
}

// Programs of this name in place of it.
class StandIn : public testing::Test {
 protected:
  void says(const std::string& script) const { bin_.program("yosys-abc", script); }
  const test::StandIns bin_{};
};
constexpr const char* kLies = "echo SATISFIABLE; echo UNSATISFIABLE; echo UNSATISFIABLE";
TEST_F(StandIn, ThatFindsWhatIsNoneHasFailed) {
  says(kLies);
  const Solved solved = solve(Engine::cec, products(), kLimit);
  EXPECT_EQ(solved.answer, Answer::failed);
  EXPECT_EQ(solved.said, "what it found is no answer");
}
TEST_F(StandIn, ThatAnswersTooLittleHasFailed) {
  says("echo UNSATISFIABLE; echo 'Cannot open input file'");
  const Solved solved = solve(Engine::cec, products(), kLimit);
  EXPECT_EQ(solved.answer, Answer::failed);
  EXPECT_EQ(solved.said, "Cannot open input file");
  EXPECT_TRUE(solved.answers.empty());
}
TEST_F(StandIn, ThatGivesUpOrIsMissingSaysSo) {
  says("echo UNDECIDED; echo UNDECIDED; echo UNDECIDED");
  EXPECT_EQ(solve(Engine::cec, products(), kLimit).answer, Answer::unknown);
  setenv("PATH", "/nonexistent", 1);
  EXPECT_EQ(solve(Engine::cec, products(), kLimit).answer, Answer::missing);
}

// The lowest bit is bit 0, whatever range the RTL gives its net.
TEST(RtlNets, CountBitsFromTheLowest) {
  netlist::Module module;
  module.nets = {{"down", {2, 3}, "", true, 2, false},
                 {"up", {4, 5}, "", true, 2, true},
                 {"one", {6}, "", true},
                 {"$made", {7}, "", false}};
  for (const netlist::Net& net : module.nets)
    module.ports.push_back({net.name, "input", "", net.bits});
  module.ports.pop_back();
  const RtlNets rtl(module, {{}, "top", {}});
  const nets::Bits& pins = rtl.pins();
  ASSERT_EQ(pins.size(), 5U);
  const auto is_called = [&](const char* wire, int bit, const char* name, Bit pin) {
    EXPECT_EQ(rtl.net(wire, bit), pin) << name;
    EXPECT_EQ(rtl.nets_in("", name), nets::Bits{pin}) << name;
  };
  is_called("down", 0, "down[2]", pins[0]);
  is_called("down", 1, "down[3]", pins[1]);
  is_called("up", 0, "up[3]", pins[2]);
  is_called("up", 1, "up[2]", pins[3]);
  is_called("one", 0, "one", pins[4]);
  EXPECT_EQ(rtl.inputs(), (std::vector<std::string>{"down", "one", "up"}));
  EXPECT_EQ(rtl.width("none"), 0);
  EXPECT_EQ(rtl.width("$made"), 0);
}

// Flip-flops a and b, and what rests on them.
netlist::Module flip_flops() {
  enum : int { clk = 2, rst, a, b, reset, two, next };
  netlist::Module module;
  module.ports = {{"clk", "input", "", {clk}}, {"rst", "input", "", {rst}}};
  const auto net = [&](const char* name, int bit) {
    module.nets.push_back({name, {bit}, "", true});
  };
  const auto flip_flop = [&](const char* name, int bit, const char* edge) {
    net(name, bit);
    module.cells.push_back({name, "$dff", "", {{"CLK_POLARITY", edge}}, {}});
    module.cells.back().pins = {{"CLK", {clk}}, {"D", {next}}, {"Q", {bit}}};
  };
  flip_flop("a", a, "1");
  flip_flop("b", b, "0");
  module.nets.front().init = "1";
  module.cells.push_back({"1", "$_ANDNOT_", "", {}, {{"A", {a}}, {"B", {rst}}, {"Y", {reset}}}});
  module.cells.push_back({"2", "$_AND_", "", {}, {{"A", {reset}}, {"B", {b}}, {"Y", {two}}}});
  module.cells.push_back({"3", "$_XOR_", "", {}, {{"A", {two}}, {"B", {a}}, {"Y", {next}}}});
  net("clk", clk);
  net("rst", rst);
  net("copy", a);
  net("reset", reset);
  net("also", reset);
  net("two", two);
  return module;
}

TEST(RtlNets, HaveFlipFlopsWithEdgesAndFirstValues) {
  const RtlNets rtl(flip_flops(), {{}, "top", {}});
  const auto& all = rtl.flip_flops();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].now, rtl.net("a", 0));
  EXPECT_EQ(all[0].initial, '1');
  EXPECT_FALSE(all[0].falls);
  EXPECT_EQ(all[0].clock, rtl.net("clk", 0));
  EXPECT_EQ(all[1].initial, 'x');
  EXPECT_TRUE(all[1].falls);
  EXPECT_EQ(rtl.inputs(), (std::vector<std::string>{"rst"}));

  // From all states, with and without rst: (a & !rst & b) ^ a.
  nets::Graph graph;
  std::map<std::size_t, Bit> given{{rtl.net("clk", 0).gate(), nets::no}};
  for (const char* name : {"a", "b", "rst"}) given[rtl.net(name, 0).gate()] = graph.input();
  const Bit next = placed_at(placed(graph, rtl.graph(), given), all[0].next);
  const auto gates = nets::run(graph, std::vector<std::uint64_t>{0xaa, 0xcc, 0xf0});
  EXPECT_EQ(nets::in_runs(gates, next) & 0xff, ((0xaa & ~0xf0 & 0xcc) ^ 0xaa) & 0xff);
}

// A copy of a flip-flop's net shows it, and what a reset takes away where there is one; what reads
// two of them does not.
TEST(RtlNets, SeeAFlipFlopThroughItsReset) {
  Source source{{}, "top", {}};
  const RtlNets plain(flip_flops(), source);
  source.asynchronous_reset = true;
  const RtlNets asynchronous(flip_flops(), source);
  for (const RtlNets* rtl : {&plain, &asynchronous}) {
    EXPECT_EQ(rtl->shown(rtl->net("a", 0)), 0U);
    EXPECT_EQ(rtl->shown(rtl->net("b", 0)), 1U);
    EXPECT_EQ(rtl->shown(rtl->net("copy", 0)), 0U);
    EXPECT_EQ(rtl->shown(rtl->net("two", 0)), std::nullopt);
  }
  EXPECT_EQ(plain.shown(plain.net("reset", 0)), std::nullopt);
  EXPECT_EQ(asynchronous.shown(asynchronous.net("reset", 0)), 0U);
  EXPECT_EQ(asynchronous.shown(asynchronous.net("also", 0)), 0U);
}

}  // namespace
}  // namespace cosim::proof
