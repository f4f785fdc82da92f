// Codes compared by the arms of their choices.
#include "tb/proof/arms.h"

#include <gtest/gtest.h>

#include "tb/proof/bits.h"
#include "tb/proof/votes.h"

namespace cosim::proof {
namespace {

// A wire w of four bits, of a register and an input.
const Rtl kRtl(
    "top",
    "(declare-fun |top#0| (|top_s|) (_ BitVec 4)) ; held\n"
    "(declare-fun |top#1| (|top_s|) Bool) ; \\load\n"
    "(define-fun |top#2| ((state |top_s|)) (_ BitVec 4) (bvadd (|top#0| state) #b0001)) ; \n"
    "(define-fun |top#3| ((state |top_s|)) (_ BitVec 4) (ite (and (|top#1| state) (= "
    "(|top#0| state) #b0000)) (bvnot (|top#0| state)) (|top#2| state))) ; \\w\n"
    "(define-fun |top_n w| ((state |top_s|)) (_ BitVec 4) (|top#3| state))\n");
const std::string kWord = bit_vector(4);

TEST(Arms, AreSeenThroughTheNamesOfTheRtl) {
  const auto choice = kRtl.choice("|top_n w|");
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->condition.text(), "(and |top#1| (= |top#0| #b0000))");
  EXPECT_EQ(choice->then.text(), "(bvnot |top#0|)");
  EXPECT_EQ(choice->otherwise.text(), "|top#2|");
  EXPECT_FALSE(kRtl.choice("|top#2|"));
  EXPECT_FALSE(kRtl.choice("|top#0|"));
}

// The formula says whether they differ, no more and no less: z3 finds nothing that denies it.
TEST(Arms, SayWhetherCodesDiffer) {
  Script script("QF_BV");
  const Expression load = script.declare("|top#1|", boolean),
                   held = script.declare("|top#0|", kWord), x = script.declare("x", kWord),
                   c = script.declare("c", boolean);
  script.add(kRtl.definitions());
  const Expression w("|top_n w|", kWord), one("#b0001", kWord);
  const auto either = [](const Expression& condition, const Expression& a, const Expression& b) {
    return Expression("ite", a.sort(), {condition, a, b});
  };
  const Expression sum("bvadd", kWord, {held, one});
  const Expression chosen = either(load, either(equal(held, x), x, sum), either(c, w, sum));
  const Expression longer("(_ zero_extend 2)", bit_vector(6), {chosen});
  std::vector<std::pair<Expression, Expression>> pairs = {{chosen, w},
                                                          {w, chosen},
                                                          {w, sum},
                                                          {x, w},
                                                          {chosen, either(c, x, sum)},
                                                          {cut(longer, 1, 4), w},
                                                          {x, held}};
  Expression wrong = truth(false);
  for (const auto& [a, b] : pairs) {
    const Expression is_so = differ(a, b, kRtl);
    wrong = disjunction(wrong, equal(is_so, equal(a, b)));
  }
  script.ask(wrong);
  const Solved solved = solve(solver_of(Engine::z3), script.text(), 60);
  if (solved.answer == Answer::missing) GTEST_SKIP() << "needs z3";
  EXPECT_EQ(solved.answer, Answer::unsat) << solved.said;
}

TEST(Definitions, LetsStandForThem) {
  const std::string head = "(set-logic QF_BV)\n(declare-const |a b| (_ BitVec 4))\n";
  EXPECT_EQ(with_lets(head + "(assert (bvult |a b| #b0100))\n" +
                      definition("|c d|", kWord, "(bvadd |a b| #b0001)") +
                      definition("e", boolean, "(= |c d| |a b|)") +
                      "(declare-const f Bool)\n(assert e)\n(assert f)\n(check-sat)\n"),
            head +
                "(declare-const f Bool)\n"
                "(assert (let ((|c d| (bvadd |a b| #b0001)))\n"
                "(let ((e (= |c d| |a b|)))\n"
                "(and true (bvult |a b| #b0100) e f))))\n(check-sat)\n");
}

}  // namespace
}  // namespace cosim::proof
