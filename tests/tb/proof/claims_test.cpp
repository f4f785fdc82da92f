// The proof of the RTL as shipped, at the smallest widths; and that each part of it is needed.
// Needs: linear
#include "tb/proof/claims.h"

#include <gtest/gtest.h>

#include "model/core/input_error.h"
#include "tb/proof/decide.h"
#include "tb/proof/machines.h"
#include "tb/proof/mutants.h"
#include "tests/support/error_of.h"
#include "tests/support/root.h"
#include "tests/support/solvers.h"

namespace cosim::proof {
namespace {

using test::can_prove, test::kLimit;

// The first machine of each design, the one with the smallest parameters.
std::vector<BuiltMachine> smallest() {
  std::vector<BuiltMachine> all;
  for (const auto& m : built_machines()) {
    const std::string design = m.title.substr(0, m.title.find(' '));
    if (all.empty() || !all.back().title.starts_with(design + ' ')) all.push_back(m);
  }
  return all;
}

Rtl rtl_of(const MachineFormula& m) {
  return read_both(source_in(test::project_root() / "rtl", m.design, m.parameters)).formulas;
}

Decision decided(const Claim& claim) {
  return decide({&claim}, {all_engines(), kLimit, 1}).front();
}

class Claims : public testing::TestWithParam<BuiltMachine> {
 protected:
  void SetUp() override {
    if (!can_prove()) GTEST_SKIP() << "needs yosys, cvc5 and z3";
  }
};

std::vector<Claim> claims_of(const MachineFormula& m, const nets::Model& model) {
  return claims_of(m, model, source_in(test::project_root() / "rtl", m.design, m.parameters));
}

TEST_P(Claims, AreProvedByEachEngine) {
  for (const Claim& c : claims_of(GetParam().formula(), GetParam().nets())) {
    for (const Engine e : all_engines()) {
      EXPECT_EQ(decide({&c}, {{e}, kLimit, 1}).front().verdict, "proved") << c.what;
    }
  }
}

HappensFromReset asked(const nets::Model& model, const MachineFormula& m,
                       Happens what = Happens::differ) {
  Source source = source_in(test::project_root() / "rtl", m.design, m.parameters);
  return FromReset(model, RtlNets(source))
      .ask(what, std::chrono::steady_clock::now() + std::chrono::seconds(kLimit), 2);
}

// What no reset leads to needs no sentence.
TEST_P(Claims, FromResetNeedNoInvariant) {
  const MachineFormula formula = GetParam().formula();
  nets::Model model = GetParam().nets();
  model.machine.invariant.resize(1);
  model.machine.invariant_after.resize(1);
  EXPECT_EQ(asked(model, formula).reached.ever, Ever::never);
}

// It is of this model, of its reset state and of every sentence; where no input is legal, of
// nothing.
TEST_P(Claims, FromResetAreRefutedByAStimulus) {
  const MachineFormula formula = GetParam().formula();
  const nets::Model model = GetParam().nets();
  nets::Model wrong = model;
  nets::Bit& last = wrong.machine.outputs.back().code.front();
  last = !last;
  HappensFromReset found = asked(wrong, formula);
  EXPECT_EQ(found.reached.ever, Ever::yes);
  ASSERT_EQ(found.clocks.size(), 1U);
  EXPECT_EQ(found.clocks.front().size(), model.machine.inputs.size());
  EXPECT_EQ(found.what, std::vector{std::string("output ") + formula.outputs.back().field.name});
  wrong.machine.legal.push_back({"nothing", nets::no});
  EXPECT_EQ(asked(wrong, formula).reached.ever, Ever::never);
  wrong = model;
  for (nets::Wire& w : wrong.machine.begins) w.code.front() = !w.code.front();
  found = asked(wrong, formula);
  EXPECT_EQ(found.reached.ever, Ever::yes);
  EXPECT_EQ(found.clocks.size(), 1U);
  wrong = model;
  wrong.machine.invariant.push_back({"never", nets::no});
  EXPECT_EQ(asked(wrong, formula).what, std::vector{std::string("not so: never")});
  wrong = model;
  wrong.machine.idle.push_back({"none", nets::no});
  EXPECT_EQ(asked(wrong, formula, Happens::stuck).reached.ever, Ever::yes);
  EXPECT_EQ(asked(model, formula, Happens::assertion).reached.ever, Ever::never);
}

// As for scripts below: nets that are of another model, or of another invariant, are refuted.
TEST_P(Claims, OnNetsNeedTheModelAndEverySentenceOfTheInvariant) {
  const MachineFormula formula = GetParam().formula();
  const nets::Model model = GetParam().nets();
  const auto by_cec = [&](const nets::Model& other, std::size_t claim) {
    const Claim c = claims_of(formula, other)[claim];
    return decide({&c}, {{Engine::cec}, kLimit, 1}).front();
  };
  for (std::size_t i = 1; i < model.machine.invariant.size(); ++i) {
    nets::Model less = model;
    less.machine.invariant.erase(less.machine.invariant.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_TRUE(by_cec(less, 1).refuted) << model.machine.invariant[i].name;
  }
  nets::Model wrong = model;
  wrong.machine.after.front().code.front() = !wrong.machine.after.front().code.front();
  EXPECT_TRUE(by_cec(wrong, 1).refuted);
  wrong = model;
  wrong.machine.outputs.front().code.front() = nets::yes;
  EXPECT_TRUE(by_cec(wrong, 1).refuted);
  wrong = model;
  wrong.machine.invariant_after.push_back({"never", nets::no});
  EXPECT_TRUE(by_cec(wrong, 1).refuted);
  wrong = model;
  wrong.machine.reset_state.back().code.back() = !wrong.machine.reset_state.back().code.back();
  EXPECT_TRUE(by_cec(wrong, 0).refuted);
  wrong = model;
  wrong.machine.invariant.push_back({"nothing", nets::no});
  EXPECT_TRUE(by_cec(wrong, 1).proved);
  EXPECT_TRUE(by_cec(wrong, 2).refuted);
}

// Without any one sentence of the invariant RTL and model part, so it is as weak as it can be. The
// ranges of the fields stand for all sentences here.
TEST_P(Claims, NeedEverySentenceOfTheInvariant) {
  const MachineFormula whole = GetParam().formula();
  const Rtl rtl = rtl_of(whole);
  for (std::size_t i = 1; i < whole.invariant.size(); ++i) {
    MachineFormula less = whole;
    less.invariant.erase(less.invariant.begin() + static_cast<std::ptrdiff_t>(i));
    less.invariant_after.erase(less.invariant_after.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_TRUE(decided(claim_step(less, rtl)).refuted) << whole.invariant[i].name;
  }
}

// What a mutant may rest on.
TEST_P(Claims, AreProvedOfWhatIsReached) {
  const MachineFormula whole = GetParam().formula();
  EXPECT_EQ(decided(reached_claim(whole)).verdict, "proved");
  MachineFormula wrong = whole;
  wrong.reached_after.push_back({"never", truth(false)});
  EXPECT_TRUE(decided(reached_claim(wrong)).refuted);
}

// Were the hypotheses contradictory, all would be proved; the cases would not be possible.
TEST_P(Claims, OfNothingAreNoProof) {
  MachineFormula empty = GetParam().formula();
  const Rtl rtl = rtl_of(empty);
  empty.invariant.push_back({"nothing", truth(false)});
  EXPECT_TRUE(decided(claim_step(empty, rtl)).proved);
  EXPECT_TRUE(decided(claim_cases(empty)).refuted);
}

TEST_P(Claims, AreOfEveryRegister) {
  const Rtl rtl = rtl_of(GetParam().formula());
  MachineFormula unnamed = GetParam().formula();
  unnamed.registers.pop_back();
  unnamed.after.pop_back();
  unnamed.reset_state.pop_back();
  EXPECT_THROW(claim_step(unnamed, rtl), InputError);
  MachineFormula other = GetParam().formula();
  other.registers.front().field.net = "no_such";
  EXPECT_THROW(claim_step(other, rtl), InputError);
}

// A port that no table names would be compared with nothing, or stay free.
TEST_P(Claims, AreOfEveryPort) {
  const Rtl rtl = rtl_of(GetParam().formula());
  const auto expect_refused = [&](const std::string& kind, auto ports) {
    MachineFormula fewer = GetParam().formula();
    const std::string name = (fewer.*ports).back().field.name;
    (fewer.*ports).pop_back();
    EXPECT_EQ(test::error_of([&] { claim_step(fewer, rtl); }),
              fewer.design + ": the RTL has an " + kind + name + " that no table names");
  };
  expect_refused("output ", &MachineFormula::outputs);
  expect_refused("input ", &MachineFormula::inputs);
}

std::string name_of(const testing::TestParamInfo<BuiltMachine>& info) {
  return info.param.title.substr(0, info.param.title.find(' '));
}
INSTANTIATE_TEST_SUITE_P(Smallest, Claims, testing::ValuesIn(smallest()), name_of);

TEST(Source, ThatIsNoneIsRefused) {
  EXPECT_THROW(source_in(test::project_root() / "model", "nothing", {}), InputError);
  if (!can_prove()) GTEST_SKIP() << "needs yosys, cvc5 and z3";
  Source source = source_in(test::project_root() / "rtl", "linear", {{"M", 5}, {"N", 2}});
  source.top = "no_such_module";
  EXPECT_THROW(read_both(source), InputError);
}

}  // namespace
}  // namespace cosim::proof
