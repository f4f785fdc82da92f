// The theorems hold, and a solver can tell where one does not.
#include "tb/proof/theorems.h"

#include <gtest/gtest.h>

#include "tb/proof/decide.h"
#include "tb/proof/integer.h"
#include "tb/support/parallel.h"
#include "tests/support/solvers.h"

namespace cosim::proof {
namespace {

using test::can_prove, test::kLimit;

void expect_all_proved(const std::vector<Theorem>& theorems) {
  std::vector<const Claim*> claims;
  for (const Theorem& t : theorems) {
    claims.push_back(&t.claim);
    claims.push_back(&t.premises);
  }
  const auto decided = decide(claims, {all_engines(), kLimit, cores()});
  for (std::size_t i = 0; i < claims.size(); ++i) {
    EXPECT_EQ(decided[i].verdict, "proved") << theorems[i / 2].sentence << claims[i]->what;
  }
}

TEST(Theorems, AreProved) {
  if (!can_prove()) GTEST_SKIP() << "needs cvc5 and z3";
  expect_all_proved(theorems());
}

// Each with its last sentence turned round: what is assumed does not prove anything.
TEST(Theorems, TurnedRoundAreRefuted) {
  if (!can_prove()) GTEST_SKIP() << "needs cvc5 and z3";
  for (const Theorem& t : theorems()) {
    Claim turned = t.claim;
    turned.queries.resize(1);
    std::string& script = turned.queries.front().script;
    const std::size_t last = script.rfind("(assert ");
    const std::size_t end = script.find(")\n(check-sat)", last);
    const std::string wrong = script.substr(last + 8, end - last - 8);
    script = script.substr(0, last) + "(assert (not " + wrong + "))\n(check-sat)\n";
    const Decision decided = decide({&turned}, {all_engines(), kLimit, 1}).front();
    EXPECT_TRUE(decided.refuted) << t.sentence << ": " << decided.verdict;
  }
}

// x^2 - x < n + 2 does not give x^2 - x < n.
TEST(Theorems, ThatAreFalseAreRefuted) {
  if (!can_prove()) GTEST_SKIP() << "needs cvc5 and z3";
  Script script("QF_NIA");
  const Integer x(script.declare("x", "Int")), n(script.declare("n", "Int"));
  script.assume((x * x - x < n + Integer(2)).expression());
  script.ask(negation((x * x - x < n).expression()));
  const Claim wrong{"a false one", Answer::unsat, {{{"any"}, script.text()}}, {}};
  EXPECT_TRUE(decide({&wrong}, {all_engines(), kLimit, 1}).front().refuted);
}

}  // namespace
}  // namespace cosim::proof
