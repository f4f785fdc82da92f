// What registers() rests on: whatever the pins do, the state stays one that the RTL's registers can
// hold.
#include <gtest/gtest.h>

#include "model/circular/stated.h"
#include "model/dda/stated.h"
#include "model/linear/stated.h"
#include "tb/stimulus/hostile.h"
#include "tests/support/model_machine.h"
#include "tests/support/shapes.h"

namespace cosim::test {
namespace {

template <class Record, class Params>
void expect_fits(const Record& record, const Params& p) {
  const auto words = to_words(record);
  const auto fields = Record::fields(p);
  for (std::size_t i = 0; i < words.size(); ++i) {
    ASSERT_EQ(words[i], low_bits(words[i], fields[i].width)) << fields[i].name;
  }
}

// Every number of the state comes back from its code.
void expect_recovered(const linear::Params& p, const linear::State<Word>& s) {
  const auto r = linear::registers(p, s);
  const Word words = r.counter4 + r.trigger30;  // to put out, a formed one included
  const bool extra = r.trigger32 != 0 && r.register5 != 0;
  ASSERT_EQ(((words - extra) << p.gamma()) + r.register5, s.left);
  if (s.formed != 0) {
    ASSERT_EQ(s.running, 1);
    ASSERT_EQ(s.coded, 1);
    ASSERT_GT(s.left, 0);
  }
}

void expect_recovered(const circular::Params& p, const circular::State<Word>& s) {
  const auto r = circular::registers(p, s);
  ASSERT_EQ(from_ones_complement(r.f, p.width + 4), s.f);
  ASSERT_EQ(from_ones_complement(r.ct7, p.width + 1), s.ct7);
  ASSERT_EQ(from_ones_complement(r.ct8, p.width + 1), s.ct8);
  ASSERT_NE(r.f, 0);                    // F has no +0
  ASSERT_NE(r.ct7, ones(p.width + 1));  // the counters have no -0
  ASSERT_NE(r.ct8, ones(p.width + 1));
}

void expect_recovered(const dda::Params& p, const dda::State<Word>& s) {
  const auto fields = dda::State<Word>::fields(p);
  const auto numbers = to_words(s), codes = to_words(dda::registers(p, s));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    ASSERT_TRUE(is_state(fields[i], numbers[i])) << fields[i].name << ' ' << numbers[i];
    ASSERT_EQ(dda::value_of(fields[i], codes[i]), numbers[i]) << fields[i].name;
  }
}

// What a design states of its state.
template <class Params, class State>
void expect_stated(const Params& p, const State& s) {
  for (const auto& [sentence, holds] : invariant(p, s)) ASSERT_TRUE(holds) << sentence;
  if constexpr (requires { reached(p, s); }) {
    for (const auto& [sentence, holds] : reached(p, s)) ASSERT_TRUE(holds) << sentence;
  }
}

template <class S>
class Reachable : public testing::Test {};
TYPED_TEST_SUITE(Reachable, Shapes, ShapeNames);

TYPED_TEST(Reachable, StatesFitTheRegisters) {
  using Design = typename TypeParam::Design;
  constexpr std::uint64_t kCases = 200, kClocks = 1000;
  std::uint64_t clocks = 0, busy = 0;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    HostileStimulus<Design> hostile(TypeParam::params, {11, i, kClocks});
    ModelMachine<Design> machine(TypeParam::params);
    typename Design::template Inputs<Word> in;
    typename Design::template Outputs<Word> seen{};
    for (; hostile.next(in, seen); ++clocks) {
      expect_fits(in, TypeParam::params);
      seen = machine.clock(in);
      expect_fits(seen, TypeParam::params);
      expect_fits(machine.registers(), TypeParam::params);
      expect_recovered(TypeParam::params, machine.state);
      expect_stated(TypeParam::params, machine.state);
      if (this->HasFatalFailure()) FAIL() << "case " << i << " clock " << clocks % kClocks;
      busy += to_words(seen)[0] != 0;  // busy, running
    }
  }
  EXPECT_EQ(clocks, kCases * kClocks);
  EXPECT_GT(busy, clocks / 200);  // the machine was at work, too
}

}  // namespace
}  // namespace cosim::test
