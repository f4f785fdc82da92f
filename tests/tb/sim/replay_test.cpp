// A stimulus runs as what it was recorded from, and from a state in its middle as from its start.
// Needs: linear, circular
#include "tb/sim/replay.h"

#include <gtest/gtest.h>

#include "tests/designs/circular/records.h"
#include "tests/support/designs.h"
#include "tests/support/error_of.h"
#include "tests/support/has.h"
#include "tests/support/model_adapter.h"
#include "tests/support/recorder.h"

namespace cosim::test {
namespace {

template <class Design>
Stimulus hostile(const Bench<Design>& bench, const HostileCase& c) {
  Stimulus s = recorded<Design>(bench.params(), HostileStimulus<Design>(bench.params(), c),
                                c.power_up(), c.clocks);
  s.machine = bench.title();
  return s;
}

// The model's states before each clock.
template <class Design>
std::vector<typename Design::template State<Word>> states(const Bench<Design>& bench,
                                                          const Stimulus& s) {
  std::vector<typename Design::template State<Word>> all{
      reset_state_of<Design, Word>(bench.params())};
  Rows<Design> rows(bench.params(), s);
  typename Design::template Inputs<Word> in;
  while (rows.next(in, {})) all.push_back(Design::next(bench.params(), all.back(), in).state);
  return all;
}

// RTL whose registers are loaded with a state goes on from there as the model does. Were a register
// not loaded, it would differ on the first clock.
template <class Design>
void expect_cut_runs_go_on() {
  for (const Bench<Design>* bench : benches_of<Design>()) {
    for (std::uint64_t i = 0; i < 4; ++i) {
      const Stimulus whole = hostile(*bench, {5, i, 600});
      ASSERT_EQ(bench->first_difference(whole), std::nullopt);
      const auto all = states(*bench, whole);
      for (std::size_t cut = 0; cut < 600; cut += 37) {
        Stimulus rest = whole;
        const auto words = to_words(all[cut]);
        rest.state.emplace(words.begin(), words.end());
        rest.clocks.erase(rest.clocks.begin(),
                          rest.clocks.begin() + static_cast<std::ptrdiff_t>(cut));
        const auto run = bench->replay(rest);
        ASSERT_FALSE(run.mismatch) << bench->title() << ", cut at " << cut << "\n"
                                   << explain(*run.mismatch);
        ASSERT_EQ(run.clocks, rest.clocks.size());
      }
    }
  }
}

template <class Design>
class ReplayFromAState : public testing::Test {};
TYPED_TEST_SUITE(ReplayFromAState, Designs, DesignNames);
TYPED_TEST(ReplayFromAState, GoesOn) { expect_cut_runs_go_on<TypeParam>(); }

TEST(Replay, OfASessionIsTheSession) {
  const auto* bench = benches_of<linear::Design>().front();
  const std::vector<linear::Job> jobs{{{27, 0b01010}, {}}, {{9, 0b00111}, {}}};
  const auto session = bench->open(1);
  Recorder<linear::Design> nobody;
  const auto run = session->draw(jobs, nobody);
  const Stimulus s = session->stimulus();
  EXPECT_EQ(s.clocks.size(), run.clocks);
  // BP and UK of both lines, as the host wrote them.
  EXPECT_EQ(s.clocks[0].back(), 27);
  EXPECT_EQ(s.clocks[1].back(), 0b01010);
}

// Differs in one instance of all: not when the case runs again.
template <class D, typename D::Params P>
class OnceFaulty : public ModelAdapter<D, P> {
  using Base = ModelAdapter<D, P>;
  using Registers = typename D::template Registers<Word>;

 public:
  explicit OnceFaulty(std::uint32_t power_up) : Base(power_up), wrong_(instances_++ == 0) {}
  Registers registers() const override {
    auto words = to_words(Base::registers());
    if (wrong_) words[0] ^= 1;
    return from_words<Registers>(words);
  }

 private:
  static inline int instances_ = 0;
  bool wrong_;
};

// What is thrown says that a case does not fail again.
template <class RunIt>
void expect_unsteady(RunIt run) {
  EXPECT_TRUE(has(error_of(run), "passes when it runs again"));
}

TEST(Replay, OfACaseThatPassesWhenItRunsAgainIsRefused) {
  using D = circular::Design;
  const DesignBench<D> hostile_one(dut_maker<OnceFaulty<D, circular::of_width(4)>>());
  expect_unsteady([&] { hostile_one.run_hostile({1, 0, 100}); });
  const DesignBench<D> replayed_one(dut_maker<OnceFaulty<D, circular::of_width(5)>>());
  const AnyBench& b = replayed_one;
  const Stimulus s{b.title(), "", 1, {}, {b.rest(), b.rest()}};
  expect_unsteady([&] { b.replay(s, Window{}); });
}

TEST(Replay, OfAModelCannotStartFromAState) {
  const auto& bench = model_bench<circular::Design, circular::of_width(4)>();
  Stimulus s{bench.title(), "", 1, bench.reset_state(), {bench.rest()}};
  EXPECT_THROW(bench.replay(s), InputError);
}

}  // namespace
}  // namespace cosim::test
