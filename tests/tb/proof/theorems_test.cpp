// The theorems hold, and a solver can tell where one does not.
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
    turned.negated.resize(1);
    std::string& script = turned.negated.front().script;
    const std::size_t last = script.rfind("(assert ");
    const std::size_t end = script.find(")\n(check-sat)", last);
    const std::string wrong = script.substr(last + 8, end - last - 8);
    script = script.substr(0, last) + "(assert (not " + wrong + "))\n(check-sat)\n";
    EXPECT_EQ(judged(turned, kLimit).verdict, "REFUTED (" + turned.negated.front().what + ")")
        << turned.sentence;
  }
}

// x^2 - x < n + 2 does not give x^2 - x < n.
TEST_F(Theorems, ThatAreFalseAreRefuted) {
  Script script("QF_NIA");
  const Integer x(script.declare("x", "Int")), n(script.declare("n", "Int"));
  script.assume((x * x - x < n + Integer(2)).expression());
  Script premises = script;
  premises.ask(truth(true));
  script.ask(negation((x * x - x < n).expression()));
  Theorem wrong{"none", "a false one", {{"any", script.text()}}, {{"any", premises.text()}}};
  EXPECT_EQ(judged(wrong, kLimit).verdict, "REFUTED (any)");
  // Of premises that cannot be all follows.
  wrong.premises = wrong.negated = {{"any", "(assert false)\n(check-sat)\n"}};
  EXPECT_EQ(judged(wrong, kLimit).verdict, "its premises cannot be (any)");
  wrong.negated = {{"any", "(assert (= no_such_symbol 1))\n(check-sat)\n"}};
  EXPECT_EQ(judged(wrong, kLimit).verdict.rfind("UNDECIDED: failed (any): ", 0), 0U);
}

}  // namespace
}  // namespace cosim::proof
