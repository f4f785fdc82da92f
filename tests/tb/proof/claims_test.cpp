// The proof of the RTL as shipped, at the smallest widths; and that each part of it is needed.
// Needs: linear
#include "tb/proof/claims.h"

#include <gtest/gtest.h>

#include "model/core/input_error.h"
#include "tb/proof/decide.h"
#include "tb/proof/from_reset.h"
#include "tb/proof/machines.h"
#include "tb/proof/mutant_questions.h"
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

RtlNets rtl_of(const nets::Model& model) {
  const auto& m = model.machine;
  return RtlNets(source_in(test::project_root() / "rtl", m.design, m.parameters));
}

Decision decided(const Claim& claim, const std::vector<Engine>& engines = all_engines()) {
  return decide({&claim}, {engines, kLimit, 1}).front();
}

class Claims : public testing::TestWithParam<BuiltMachine> {
 protected:
  void SetUp() override {
    if (!can_prove()) GTEST_SKIP() << "needs yosys";
  }
};

TEST_P(Claims, AreProvedByEachEngine) {
  const nets::Model model = GetParam().nets();
  const auto& m = model.machine;
  for (const Claim& c :
       claims_of(model, source_in(test::project_root() / "rtl", m.design, m.parameters))) {
    for (const Engine e : all_engines()) EXPECT_EQ(decided(c, {e}).verdict, "proved") << c.what;
  }
}

HappensFromReset asked(const nets::Model& model, const RtlNets& rtl,
                       Happens what = Happens::differ) {
  return FromReset(model, rtl)
      .ask(what, std::chrono::steady_clock::now() + std::chrono::seconds(kLimit), 2);
}

// What no reset leads to needs no sentence.
TEST_P(Claims, FromResetNeedNoInvariant) {
  nets::Model model = GetParam().nets();
  model.machine.invariant.resize(1);
  model.machine.invariant_after.resize(1);
  EXPECT_EQ(asked(model, rtl_of(model)).reached.ever, Ever::never);
}

// It is of this model, of its reset state and of every sentence; where no input is legal, of
// nothing.
TEST_P(Claims, FromResetAreRefutedByAStimulus) {
  const nets::Model model = GetParam().nets();
  const RtlNets rtl = rtl_of(model);
  nets::Model wrong = model;
  nets::Bit& last = wrong.machine.outputs.back().code.front();
  last = !last;
  HappensFromReset found = asked(wrong, rtl);
  EXPECT_EQ(found.reached.ever, Ever::yes);
  ASSERT_EQ(found.clocks.size(), 1U);
  EXPECT_EQ(found.clocks.front().size(), model.machine.inputs.size());
  EXPECT_EQ(found.what,
            std::vector{std::string("output ") + model.machine.outputs.back().field.name});
  wrong.machine.legal.push_back({"nothing", nets::no});
  EXPECT_EQ(asked(wrong, rtl).reached.ever, Ever::never);
  wrong = model;
  for (nets::Wire& w : wrong.machine.begins) w.code.front() = !w.code.front();
  found = asked(wrong, rtl);
  EXPECT_EQ(found.reached.ever, Ever::yes);
  EXPECT_EQ(found.clocks.size(), 1U);
  wrong = model;
  wrong.machine.invariant.push_back({"never", nets::no});
  EXPECT_EQ(asked(wrong, rtl).what, std::vector{std::string("not so: never")});
  wrong = model;
  wrong.machine.idle.push_back({"none", nets::no});
  EXPECT_EQ(asked(wrong, rtl, Happens::stuck).reached.ever, Ever::yes);
  EXPECT_EQ(asked(model, rtl, Happens::assertion).reached.ever, Ever::never);
}

// A claim of another model, or of another invariant, is refuted. The ranges of the fields stand for
// all sentences here.
TEST_P(Claims, NeedTheModelAndTheInvariant) {
  const nets::Model model = GetParam().nets();
  const RtlNets rtl = rtl_of(model);
  const auto step = [&](const nets::Model& other) { return decided(claim_step(other, rtl)); };
  nets::Model wrong = model;
  wrong.machine.after.front().code.front() = !wrong.machine.after.front().code.front();
  EXPECT_TRUE(step(wrong).refuted);
  wrong = model;
  wrong.machine.outputs.front().code.front() = nets::yes;
  EXPECT_TRUE(step(wrong).refuted);
  wrong = model;
  wrong.machine.invariant_after.push_back({"never", nets::no});
  EXPECT_TRUE(step(wrong).refuted);
  wrong = model;
  wrong.machine.reset_state.back().code.back() = !wrong.machine.reset_state.back().code.back();
  EXPECT_TRUE(decided(claim_base_case(wrong, rtl)).refuted);
}

// What a mutant may rest on.
TEST_P(Claims, AreProvedOfWhatIsReached) {
  nets::Model model = GetParam().nets();
  EXPECT_EQ(decided(reached_claim(model)).verdict, "proved");
  model.machine.reached_after.push_back({"never", nets::no});
  EXPECT_TRUE(decided(reached_claim(model)).refuted);
}

// Were the hypotheses contradictory, all would be proved; the cases would not be possible.
TEST_P(Claims, OfNothingAreNoProof) {
  nets::Model empty = GetParam().nets();
  empty.machine.invariant.push_back({"nothing", nets::no});
  EXPECT_TRUE(decided(claim_step(empty, rtl_of(empty))).proved);
  EXPECT_TRUE(decided(claim_cases(empty)).refuted);
}

TEST_P(Claims, AreOfEveryRegister) {
  nets::Model unnamed = GetParam().nets();
  const RtlNets rtl = rtl_of(unnamed);
  unnamed.machine.registers.pop_back();
  unnamed.machine.after.pop_back();
  unnamed.machine.reset_state.pop_back();
  EXPECT_EQ(test::error_of([&] { claim_step(unnamed, rtl); }),
            unnamed.machine.design + ": the RTL has a register that the model does not have");
  nets::Model other = GetParam().nets();
  other.machine.registers.front().field.net = "no_such";
  EXPECT_THROW(claim_step(other, rtl), InputError);
}

// A port that the model does not have would be compared with nothing, or stay free.
TEST_P(Claims, AreOfEveryPort) {
  const nets::Model whole = GetParam().nets();
  const RtlNets rtl = rtl_of(whole);
  const auto expect_refused = [&](const std::string& kind, auto ports) {
    nets::Model fewer = whole;
    const std::string name = (fewer.machine.*ports).back().field.name;
    (fewer.machine.*ports).pop_back();
    EXPECT_EQ(
        test::error_of([&] { claim_step(fewer, rtl); }),
        fewer.machine.design + ": the RTL has an " + kind + name + " that the model does not have");
  };
  using nets::Machine;
  expect_refused("output ", &Machine::outputs);
  expect_refused("input ", &Machine::inputs);
}

std::string name_of(const testing::TestParamInfo<BuiltMachine>& info) {
  return info.param.title.substr(0, info.param.title.find(' '));
}
INSTANTIATE_TEST_SUITE_P(Smallest, Claims, testing::ValuesIn(smallest()), name_of);

TEST(Source, ThatIsNoneIsRefused) {
  EXPECT_THROW(source_in(test::project_root() / "model", "nothing", {}), InputError);
  if (!can_prove()) GTEST_SKIP() << "needs yosys";
  Source source = source_in(test::project_root() / "rtl", "linear", {{"M", 5}, {"N", 2}});
  source.top = "no_such_module";
  EXPECT_THROW(RtlNets{source}, InputError);
}

}  // namespace
}  // namespace cosim::proof
