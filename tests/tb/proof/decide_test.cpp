// What engines that are missing, slow, undecided, wrong or of two minds come to: never a proof.
#include "tb/proof/decide.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"
#include "tests/support/has.h"
#include "tests/support/stand_ins.h"

namespace cosim::proof {
namespace {

Questions asking(const std::vector<std::string>& names) {
  Questions questions;
  for (const std::string& name : names) questions.asked.push_back({name, nets::no});
  return questions;
}
const Claim claim{"a claim", Answer::unsat, asking({"the question"})};

Solved answer(Answer a) {
  Solved s;
  s.answer = a;
  if (a == Answer::sat || a == Answer::unsat || a == Answer::unknown) s.answers = {a};
  return s;
}
Decision decision(Answer cec, Answer cadical) {
  return judged(claim, {{Engine::cec, answer(cec)}, {Engine::cadical, answer(cadical)}});
}

TEST(Engines, AreTakenInTheirOrder) {
  EXPECT_EQ(engines_of("cadical,cec"), (std::vector{Engine::cadical, Engine::cec}));
  EXPECT_EQ(engines_of("cec"), std::vector{Engine::cec});
}

TEST(Engines, AreRefusedTwiceUnknownOrWhereThereIsNone) {
  const auto refusal = [](const char* list) { return test::error_of([&] { engines_of(list); }); };
  const std::string takes = ": takes cec and cadical, each once";
  EXPECT_EQ(refusal("cec,cadical,cec"), "--engines 'cec,cadical,cec'" + takes);
  EXPECT_EQ(refusal("cec,z3"), "--engines 'cec,z3'" + takes);
  EXPECT_EQ(refusal("cec,,cadical"), "--engines 'cec,,cadical'" + takes);
  EXPECT_EQ(refusal(""), "--engines: needs one");
}

void expect_is(const Decision& d, bool proved, bool refuted, const std::string& verdict) {
  EXPECT_EQ(d.proved, proved);
  EXPECT_EQ(d.refuted, refuted);
  EXPECT_EQ(d.verdict, verdict);
}

TEST(Decision, IsAProofWhereAllAgree) {
  expect_is(decision(Answer::unsat, Answer::unsat), true, false, "proved");
  EXPECT_TRUE(judged(claim, {{Engine::cec, answer(Answer::unsat)}}).proved);
  EXPECT_EQ(judged(claim, {}).verdict, "UNDECIDED: no engine can be asked");
}

TEST(Decision, IsARefutationWhereNoneDenies) {
  expect_is(decision(Answer::sat, Answer::sat), false, true,
            "REFUTED: cec sat (the question), cadical sat (the question)");
  expect_is(decision(Answer::stopped, Answer::sat), false, true,
            "REFUTED: cadical sat (the question)");
}

TEST(Decision, IsNoProofWhereAnEngineIsMissingSlowOrUndecided) {
  for (const Answer a : {Answer::missing, Answer::timed_out, Answer::unknown, Answer::failed}) {
    for (const Decision& d : {decision(a, Answer::unsat), decision(Answer::unsat, a)}) {
      EXPECT_FALSE(d.proved);
      EXPECT_FALSE(d.refuted);
      test::expect_has(d.verdict, {"UNDECIDED, 1 of 2: ", to_text(a)});
    }
  }
}

TEST(Decision, IsNeitherWhereTheEnginesDisagree) {
  const Decision d = decision(Answer::sat, Answer::unsat);
  expect_is(d, false, false, "THE ENGINES DISAGREE: cec sat (the question), cadical unsat");
  EXPECT_TRUE(d.disagree);
}

// One answer of many that is missing or other than wanted is enough.
TEST(Decision, NeedsEveryAnswer) {
  const Claim two{"two", Answer::sat, asking({"first", "second"})};
  Solved both, one, other;
  both.answer = one.answer = other.answer = Answer::sat;
  both.answers = {Answer::sat, Answer::sat};
  one.answers = {Answer::sat};
  other.answers = {Answer::sat, Answer::unsat};
  const auto with = [&](const Solved& second) {
    return judged(two, {{Engine::cec, both}, {Engine::cadical, second}});
  };
  EXPECT_TRUE(with(both).proved);
  EXPECT_FALSE(with(one).proved);
  EXPECT_FALSE(with(other).proved);
  EXPECT_TRUE(test::has(with(other).verdict, "unsat (second)"));
}

// Whatever one engine does, the other is heard, on one thread and on several; and a claim is told
// as soon as it is known.
TEST(Decision, IsToldOfEachClaim) {
  const test::StandIns bin{};
  bin.program("yosys-abc", "echo UNDECIDED");
  for (const unsigned jobs : {1U, 2U, 4U}) {
    std::vector<std::string> told;
    const auto all = decide({&claim, &claim}, {all_engines(), 10, jobs},
                            [&](std::size_t, const Decision& d) { told.push_back(d.verdict); });
    const std::string undecided = "UNDECIDED, 1 of 2: cec unknown (the question), cadical unsat";
    EXPECT_EQ(told, std::vector(2, undecided));
    EXPECT_EQ(all.size(), 2U);
  }
}

// That something can be needs one, whose answer is tried; that it cannot be needs all.
TEST(Decision, AsksOneWhetherSomethingCanBe) {
  const auto asked = [](Answer wanted, const std::vector<Engine>& engines) {
    std::string names;
    const Claim one{"one", wanted, asking({"it"})};
    const Decision d = decide({&one}, {engines, 10, 1}).front();
    for (const Opinion& o : d.opinions) names += to_text(o.engine) + ' ';
    return names;
  };
  EXPECT_EQ(asked(Answer::sat, all_engines()), "cadical ");
  EXPECT_EQ(asked(Answer::sat, {Engine::cec}), "cec ");
  EXPECT_EQ(asked(Answer::unsat, all_engines()), "cec cadical ");
}

// What one has refuted, and what it found is so, the other need not: it is stopped.
TEST(Decision, StopsTheOtherWhereOneHasRefutedTheClaim) {
  const test::StandIns bin{};
  bin.program("yosys-abc", "while :; do :; done");
  Questions can_be;
  can_be.asked.push_back({"it", nets::yes});
  const Claim wrong{"wrong", Answer::unsat, can_be};
  constexpr int for_ever = 86400;
  const Decision d = decide({&wrong}, {all_engines(), for_ever, 2}).front();
  EXPECT_TRUE(d.refuted);
  EXPECT_EQ(d.verdict, "REFUTED: cadical sat (it)");
}

}  // namespace
}  // namespace cosim::proof
