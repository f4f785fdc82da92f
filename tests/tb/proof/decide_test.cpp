// What solvers that are missing, slow, undecided, wrong or of two minds come to: never a proof.
#include "tb/proof/decide.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "tb/proof/votes.h"
#include "tests/support/has.h"
#include "tests/support/stand_ins.h"

namespace cosim::proof {
namespace {

constexpr const char* kFalse = "(set-logic QF_BV)\n(assert false)\n(check-sat)\n";
constexpr const char* kTrue = "(set-logic QF_BV)\n(check-sat)\n";

Solved answer(Answer a) {
  Solved s;
  s.answer = a;
  if (a == Answer::sat || a == Answer::unsat || a == Answer::unknown) s.answers = {a};
  return s;
}
const Claim claim{"a claim", Answer::unsat, {{{"the question"}, ""}}, {}};

Decision decision(Answer cvc5, Answer z3) {
  return judged(claim, {{Engine::cvc5, {answer(cvc5)}}, {Engine::z3, {answer(z3)}}});
}

// With that question of nets, too.
Claim with_nets(Claim of, const char* asked) {
  NetQuestions nets;
  nets.asked.push_back({asked, nets::no});
  of.nets = std::make_shared<const NetQuestions>(nets);
  return of;
}

std::string refusal(const std::string& list, const std::vector<Engine>& all = all_engines()) {
  try {
    return "taken: " + listed(engines_of(list, all));
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Engines, AreTakenInTheirOrder) {
  EXPECT_EQ(engines_of("cvc5,cec"), (std::vector{Engine::cvc5, Engine::cec}));
  EXPECT_EQ(engines_of("z3"), std::vector{Engine::z3});
}

TEST(Engines, AreRefusedTwiceUnknownOrWhereThereIsNone) {
  const std::string takes = ": takes cec, z3 and cvc5, each once";
  EXPECT_EQ(refusal("cec,z3,cec"), "--engines 'cec,z3,cec'" + takes);
  EXPECT_EQ(refusal("cec,abc"), "--engines 'cec,abc'" + takes);
  EXPECT_EQ(refusal("cec,,z3"), "--engines 'cec,,z3'" + takes);
  EXPECT_EQ(refusal(""), "--engines: needs one");
  EXPECT_EQ(refusal("cec", {Engine::z3, Engine::cvc5}),
            "--engines 'cec': takes z3 and cvc5, each once");
}

void expect_is(const Decision& d, bool proved, bool refuted, const std::string& verdict) {
  EXPECT_EQ(d.proved, proved);
  EXPECT_EQ(d.refuted, refuted);
  EXPECT_EQ(d.verdict, verdict);
}

TEST(Decision, IsAProofWhereTwoAgree) {
  expect_is(decision(Answer::unsat, Answer::unsat), true, false, "proved");
}

TEST(Decision, IsARefutationWhereNoneDenies) {
  expect_is(decision(Answer::sat, Answer::sat), false, true,
            "REFUTED: cvc5 sat (the question), z3 sat (the question)");
}

TEST(Decision, IsNoProofWhereASolverIsMissingSlowOrUndecided) {
  for (const Answer a : {Answer::missing, Answer::timed_out, Answer::unknown, Answer::failed}) {
    for (const Decision& d : {decision(a, Answer::unsat), decision(Answer::unsat, a)}) {
      EXPECT_FALSE(d.proved);
      EXPECT_FALSE(d.refuted);
      test::expect_has(d.verdict, {"UNDECIDED, 1 of 2: ", to_text(a)});
    }
  }
}

TEST(Decision, IsNeitherWhereTheSolversDisagree) {
  expect_is(decision(Answer::sat, Answer::unsat), false, false,
            "THE ENGINES DISAGREE: cvc5 sat (the question), z3 unsat");
}

// One answer of many that is missing or other than wanted is enough.
TEST(Decision, NeedsEveryAnswer) {
  const Claim two{"two", Answer::sat, {{{"first", "second"}, ""}}, {}};
  Solved both, one, other;
  both.answer = one.answer = other.answer = Answer::sat;
  both.answers = {Answer::sat, Answer::sat};
  one.answers = {Answer::sat};
  other.answers = {Answer::sat, Answer::unsat};
  const auto with = [&](const Solved& second) {
    return judged(two, {{Engine::cvc5, {both}}, {Engine::z3, {second}}});
  };
  EXPECT_TRUE(with(both).proved);
  EXPECT_FALSE(with(one).proved);
  EXPECT_FALSE(with(other).proved);
  EXPECT_TRUE(test::has(with(other).verdict, "unsat (second)"));
}

// Of three, two decide, and the third is named; but none may say the opposite.
TEST(Decision, NeedsTwoOfThree) {
  const auto third = [](Answer a) {
    return judged(claim, {{Engine::cvc5, {answer(Answer::unsat)}},
                          {Engine::z3, {answer(a)}},
                          {Engine::cvc5, {answer(Answer::unsat)}}});
  };
  EXPECT_TRUE(third(Answer::timed_out).proved);
  EXPECT_EQ(third(Answer::timed_out).verdict, "proved, z3 timed out (the question)");
  EXPECT_FALSE(third(Answer::sat).proved);
  EXPECT_FALSE(third(Answer::sat).refuted);
  const std::vector<Opinion> one{{Engine::z3, {answer(Answer::unsat)}}};
  EXPECT_FALSE(judged(claim, one).proved);
  EXPECT_TRUE(judged(claim, one, 1).proved);
  EXPECT_EQ(judged(claim, {}).verdict, "UNDECIDED, 0 of 2: no engine can be asked");
}

// Of two questions z3 answers one and cvc5 the other, and cec both: each has two.
TEST(Decision, NeedsTwoOfEachQuestion) {
  const Claim two =
      with_nets({"two", Answer::unsat, {{{"first"}, ""}, {{"second"}, ""}}, {}}, "both");
  const auto with = [&](Answer z3_second, Answer cvc5_second) {
    return judged(two, {{Engine::cec, {answer(Answer::unsat)}},
                        {Engine::z3, {answer(Answer::unsat), answer(z3_second)}},
                        {Engine::cvc5, {answer(Answer::stopped), answer(cvc5_second)}}});
  };
  EXPECT_EQ(with(Answer::stopped, Answer::unsat).verdict, "proved");
  EXPECT_EQ(with(Answer::timed_out, Answer::unsat).verdict, "proved, z3 timed out (second)");
  EXPECT_FALSE(with(Answer::timed_out, Answer::timed_out).proved);
  EXPECT_FALSE(with(Answer::timed_out, Answer::timed_out).refuted);
  EXPECT_TRUE(test::has(with(Answer::stopped, Answer::sat).verdict, "THE ENGINES DISAGREE"));
}

// An engine that never ends holds up no other: not where two threads wait for two engines, and not
// where there is one thread.
TEST(Decision, ComesFromTheOthersWhereAnEngineHangs) {
  const test::StandIns bin{};
  bin.program("z3", "while :; do :; done");
  bin.program("cvc5", "echo unsat");
  bin.program("yosys-abc", "echo UNSATISFIABLE");
  const Claim no = with_nets({"no", Answer::unsat, {{{"it"}, ""}}, {}}, "it");
  constexpr int for_ever = 86400;
  for (const unsigned jobs : {1U, 2U, 4U}) {
    std::size_t told = 0;
    const auto all = decide({&no, &no}, {all_engines(), for_ever, jobs, 1},
                            [&](std::size_t, const Decision& d) { told += d.proved ? 1 : 0; });
    EXPECT_EQ(told, 2U);
    for (const Decision& d : all) {
      EXPECT_EQ(d.verdict, "proved");
      EXPECT_EQ(d.opinions.size(), 2U);
    }
  }
}

// The engines wait with what is slow until they hear that the other claim is told.
TEST(Decision, IsToldBeforeOthersAreThere) {
  const test::StandIns bin{};
  const std::string told = bin.folder.path("told");
  for (const char* name : {"z3", "cvc5"}) {
    bin.program(name, "for script; do :; done\nwhile grep -q slow $script && ! [ -e " + told +
                          " ]; do :; done\necho unsat");
  }
  const Claim quick{"quick", Answer::unsat, {{{"it"}, ""}}, {}};
  const Claim slow{"slow", Answer::unsat, {{{"it"}, "; slow\n"}}, {}};
  const auto all = decide({&slow, &quick}, {{Engine::z3, Engine::cvc5}, 4, 4, 1},
                          [&](std::size_t i, const Decision& d) {
                            if (i == 1 && d.proved) std::ofstream(told) << "so";
                          });
  EXPECT_EQ(all.front().verdict, "proved");
}

// Two are asked, and the third only where these are not of one mind.
TEST(Decision, AsksTheThirdWhereTwoDoNotDo) {
  const Claim no{"no", Answer::unsat, {{{"it"}, kFalse}}, {}};
  const auto asked = [&](const std::vector<Engine>& engines, const Claim& of) {
    std::string names;
    const Decision d = decide({&of}, {engines, 10, 1}).front();
    for (const Opinion& o : d.opinions) names += to_text(o.engine) + ' ';
    return names;
  };
  // A claim without nets is none for cec.
  EXPECT_EQ(asked({Engine::cec, Engine::z3, Engine::cvc5}, no), "z3 cvc5 ");
  EXPECT_EQ(asked({Engine::z3}, no), "z3 ");
  EXPECT_EQ(asked({Engine::cec}, no), "");
  Claim on_nets = with_nets(no, "it");
  EXPECT_EQ(asked({Engine::cec, Engine::z3, Engine::cvc5}, on_nets), "cec z3 ");
  // A script that is none: z3 fails, and cvc5 is asked too.
  on_nets.queries.front().script = "(";
  EXPECT_EQ(asked({Engine::cec, Engine::z3, Engine::cvc5}, on_nets), "cec z3 cvc5 ");
}

// z3 is asked both at a time: of a script that spoils the others each is asked again alone.
TEST(Decision, ComesOfEachScriptAloneWhereManyCannotBeRead) {
  const Claim two{"two", Answer::unsat, {{{"first"}, "("}, {{"second"}, kFalse}}, {}};
  const Decision d = decide({&two}, {{Engine::z3}, 10, 1}).front();
  const std::vector<Solved>& solved = d.opinions.front().solved;
  if (solved.front().answer == Answer::missing) GTEST_SKIP() << "needs z3";
  EXPECT_EQ(solved.front().answer, Answer::failed);
  EXPECT_EQ(solved.back().answer, Answer::unsat);
}

TEST(Solver, ThatIsMissingIsSaidToBe) {
  EXPECT_EQ(solve({"none", "no_such_solver"}, kFalse, 10).answer, Answer::missing);
}
TEST(Solver, ThatTakesTooLongIsStopped) {
  const Solved works = solve({"busy", "sha256sum /dev/zero"}, kFalse, 1);
  EXPECT_EQ(works.answer, Answer::timed_out);
  EXPECT_NEAR(works.seconds, 1, 0.5);
  // cvc5 takes the signal of its limit for an occasion to print something else.
  const std::string talks = "trap 'echo interrupted; exit 1' XCPU\nwhile :; do :; done\n";
  EXPECT_EQ(solve({"talking", "bash"}, talks, 1).answer, Answer::timed_out);
  // One that waits for what never comes takes no time of the processor.
  EXPECT_EQ(solve({"waiting", "tail -f"}, kFalse, 1).answer, Answer::timed_out);
}
// As a solver is on a busy computer: its time goes by, and it has had little of it.
TEST(Solver, ThatGetsNoTimeIsNotStopped) {
  const Solver waits{"waiting", "awk BEGIN{system(\"sleep\\t3\")}1"};
  EXPECT_EQ(solve(waits, "unsat\n", 1).answer, Answer::unsat);
}
TEST(Solver, ThatSaysMoreThanAnAnswerHasNotUnderstood) {
  const std::string wrong = std::string("(assert (= no_such_symbol 1))\n") + kFalse;
  for (const Solver& s : solvers()) {
    const Solved solved = solve(s, wrong, 10);
    if (solved.answer == Answer::missing) GTEST_SKIP() << "needs " << s.name;
    EXPECT_EQ(solved.answer, Answer::failed) << s.name;
    EXPECT_FALSE(solved.said.empty());
  }
}
TEST(Solver, AnswersManyScriptsAtATime) {
  const Solver& z3 = solver_of(Engine::z3);
  const auto all = solve_all(z3, {kFalse, kTrue, "(check-set)\n", kFalse}, 10);
  if (all.front().answer == Answer::missing) GTEST_SKIP() << "needs z3";
  std::vector<Answer> answers;
  for (const Solved& s : all) answers.push_back(s.answer);
  EXPECT_EQ(answers, (std::vector{Answer::unsat, Answer::sat, Answer::failed, Answer::unsat}));
  EXPECT_FALSE(all[2].said.empty());
  EXPECT_GT(all.front().seconds, 0);
}
// What one said before it was stopped counts, and nothing counts of what it had not come to.
TEST(Solver, ThatIsStoppedAmongManyHasAnsweredTheFirst) {
  const std::string script = "reset() { :; }\necho unsat\n";
  const Solver shell{"shell", "bash"};
  const auto all = solve_all(shell, {script, "while :; do :; done\n", kFalse}, 1);
  std::vector<Answer> answers;
  for (const Solved& s : all) answers.push_back(s.answer);
  EXPECT_EQ(answers, (std::vector{Answer::unsat, Answer::timed_out, Answer::timed_out}));
}
TEST(Solver, AnswersAQuestion) {
  for (const Solver& s : solvers()) {
    const Solved no = solve(s, kFalse, 10), yes = solve(s, kTrue, 10);
    if (no.answer == Answer::missing) GTEST_SKIP() << "needs " << s.name;
    EXPECT_EQ(no.answer, Answer::unsat) << s.name << no.said;
    EXPECT_EQ(yes.answer, Answer::sat) << s.name << yes.said;
  }
}

}  // namespace
}  // namespace cosim::proof
