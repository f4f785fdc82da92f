// The theorems hold, and an engine can tell where one does not.
#include "tb/proof/theorems.h"

#include <gtest/gtest.h>

#include "tb/proof/integer.h"
#include "tb/util/parallel.h"
#include "tests/support/solvers.h"

namespace cosim::proof {
namespace {

using test::kLimit;

class Theorems : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_installed("z3")) GTEST_SKIP() << "needs z3";
  }
};

TEST_F(Theorems, AreProved) {
  const std::vector<Theorem> all = theorems();
  in_parallel(all.size(), cores(), [&](std::uint64_t i) {
    EXPECT_EQ(judged(all[i], kLimit).verdict, "proved") << all[i].sentence;
    return true;
  });
}

// Each with its last sentence turned round: what is assumed does not prove anything.
TEST_F(Theorems, TurnedRoundAreRefuted) {
  for (Theorem turned : theorems()) {
    std::string what = "any";
    if (turned.on_integers) {
      std::string& script = turned.on_integers->negated;
      const std::size_t last = script.rfind("(assert ");
      const std::size_t end = script.find(")\n(check-sat)", last);
      const std::string wrong = script.substr(last + 8, end - last - 8);
      script = script.substr(0, last) + "(assert (not " + wrong + "))\n(check-sat)\n";
    } else {
      turned.on_bits.resize(1);
      Questions& questions = turned.on_bits.front().questions;
      what = turned.on_bits.front().what;
      questions.asked[0].bit =
          questions.graph.and_of(questions.asked[1].bit, !questions.asked[0].bit);
    }
    EXPECT_EQ(judged(turned, kLimit).verdict, "REFUTED (" + what + ")") << turned.sentence;
  }
}

// x^2 - x < n + 2 does not give x^2 - x < n.
TEST_F(Theorems, OnIntegersThatAreFalseAreRefuted) {
  Script script;
  const Integer x = script.integer("x"), n = script.integer("n");
  script.assume(x * x - x < n + Integer(2));
  Theorem wrong{"none", "a false one"};
  wrong.on_integers = {script.asked(!(x * x - x < n)), script.asked(true)};
  EXPECT_EQ(judged(wrong, kLimit).verdict, "REFUTED (any)");
  // Of premises that cannot be all follows.
  wrong.on_integers = {"(assert false)\n(check-sat)\n", "(assert false)\n(check-sat)\n"};
  EXPECT_EQ(judged(wrong, kLimit).verdict, "its premises cannot be (any)");
  wrong.on_integers->negated = "(assert (= no_such_symbol 1))\n(check-sat)\n";
  EXPECT_EQ(judged(wrong, kLimit).verdict.rfind("UNDECIDED: failed (any): ", 0), 0U);
}

TEST(TheoremsOnBits, AreNotProvedByNoQuestion) {
  const auto nothing = at_every_width(
      "none", "of no design", [](const Widths&, FreeNumbers&) { return nets::Truth(true); });
  EXPECT_FALSE(judged(nothing, kLimit).proved);
}

// x + 1 > x, unless it wraps in 8 bits.
TEST(TheoremsOnBits, ThatAreFalseAreRefuted) {
  FreeNumbers free;
  const nets::Number x = free.number("x", 8);
  Theorem theorem{"none", "a false one"};
  theorem.on_bits = {free.asked("wraps", !(low_bits(x + nets::Number(1), 8) > x))};
  EXPECT_EQ(judged(theorem, kLimit).verdict, "REFUTED (wraps)");
  free.assume(x < nets::Number(255));
  theorem.on_bits = {free.asked("x < 255", !(low_bits(x + nets::Number(1), 8) > x))};
  EXPECT_EQ(judged(theorem, kLimit).verdict, "proved");
  free.assume(x > nets::Number(254));
  theorem.on_bits = {free.asked("none", x > nets::Number(0))};
  EXPECT_EQ(judged(theorem, kLimit).verdict, "its premises cannot be (none)");
}

}  // namespace
}  // namespace cosim::proof
