// Questions about gates, and what the engines say of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <filesystem>

#include "tb/nets/number.h"
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
  const RtlNets rtl("top", ".model top\n.inputs up[2] up[3] down[3] down[2] one\n.end\n",
                    "  wire width 2 offset 2 input 1 \\down\n  attribute \\src \"x\"\n"
                    "  wire width 2 upto offset 2 input 2 \\up\n  wire input 3 \\one\n"
                    "  wire width 4 $made\n");
  const auto name = [&](const char* wire, int bit) { return rtl.cells().nets[rtl.net(wire, bit)]; };
  EXPECT_EQ(name("down", 0), "down[2]");
  EXPECT_EQ(name("down", 1), "down[3]");
  EXPECT_EQ(name("up", 0), "up[3]");
  EXPECT_EQ(name("up", 1), "up[2]");
  EXPECT_EQ(name("one", 0), "one");
  EXPECT_EQ(rtl.width("none"), 0);
  EXPECT_EQ(rtl.width("$made"), 0);
}

// A copy of a flip-flop's net shows it, and what a reset takes away where there is one; what reads
// two of them, or turns one over without a reset, does not.
TEST(RtlNets, SeeAFlipFlopThroughItsReset) {
  const std::string blif =
      ".model top\n.inputs rst clk\n.latch a a re clk 2\n.latch b b re clk 2\n"
      ".names a copy\n1 1\n.names rst copy reset\n01 1\n.names reset also\n1 1\n"
      ".names reset b two\n11 1\n.names two more\n1 1\n.end\n";
  const RtlNets plain("top", blif, ""), asynchronous("top", blif, "", true);
  const auto shown = [](const RtlNets& rtl, const std::string& name) {
    const auto& all = rtl.cells().nets;
    const auto at = std::find(all.begin(), all.end(), name) - all.begin();
    return rtl.shown(static_cast<std::size_t>(at));
  };
  for (const RtlNets* rtl : {&plain, &asynchronous}) {
    EXPECT_EQ(shown(*rtl, "a"), 0U);
    EXPECT_EQ(shown(*rtl, "b"), 1U);
    EXPECT_EQ(shown(*rtl, "copy"), 0U);
    EXPECT_EQ(shown(*rtl, "two"), std::nullopt);
    EXPECT_EQ(shown(*rtl, "more"), std::nullopt);
  }
  EXPECT_EQ(shown(plain, "reset"), std::nullopt);
  EXPECT_EQ(shown(asynchronous, "reset"), 0U);
  EXPECT_EQ(shown(asynchronous, "also"), 0U);
}

}  // namespace
}  // namespace cosim::proof
