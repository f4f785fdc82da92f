// Mutants of RTL with streams in lanes: one clock and several, resets without a clock, drivers of a
// design's own.
#include "tb/mutation/stream_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "tb/mutation/cases.h"
#include "tb/mutation/subject.h"
#include "tb/stream/stream_bench.h"
#include "tb/util/process.h"
#include "tests/stream/designs/crosses.h"
#include "tests/stream/designs/pairs.h"
#include "tests/stream/designs/serial.h"
#include "tests/support/error_of.h"
#include "tests/support/root.h"

namespace cosim::mutation {
namespace {

// There is no RTL but that of lanes.
class None final : public StreamDut {
 public:
  explicit None(std::uint32_t) {}
  std::vector<Net> nets(const Ports&) override { return {}; }
  void eval() override {}
};

template <class M, clocked::Text NAME, int fault>
struct OfTest {
  using Model = M;
  struct Says {
    static constexpr const char* name = NAME.text;
    static constexpr std::array<std::array<Parameter, 1>, 1> parameters{{{{{"FAULT", fault}}}}};
  };
  using Design = clocked::StreamDesign<Says, M>;
  static constexpr typename Design::Params params{};
  static constexpr const char *clock = "clk", *clocks = "";
};
template <int fault>
struct OfPairs : OfTest<Pairs<fault>, "pairs", fault> {
  static constexpr const char* clock = "clock";
};
template <int fault>
struct OfCrosses : OfTest<Crosses<fault>, "crosses", fault> {
  static constexpr const char *clock = "", *clocks = "fast\nfalling slow\n";
};
using OfSerial = OfTest<Serial<0>, "serial", 0>;

template <class Trait>
struct Rtl {
  StreamBench<Trait, None> bench;
  Cases cases = cases_of(bench);

  proof::Source source() const {
    const auto folder = test::project_root() / "tests/stream/designs";
    proof::Source source{{folder / (bench.design() + ".v")}, bench.design(), bench.parameters()};
    source.clocks_are_inputs = bench.shape().clocks_are_inputs();
    return source;
  }
};

class StreamMutants : public testing::Test {
 protected:
  void SetUp() override {
    if (!is_installed("yosys")) GTEST_SKIP() << "there is no yosys";
  }
};

constexpr std::size_t some_cases = 3;

// How a mutant ends by itself, on its lane.
Outcome alone(StreamLanes& lanes, const StreamShape& shape, std::size_t lane, const Cases& cases) {
  for (std::size_t c = 0; c < some_cases; ++c) {
    lanes.choose(lane);
    const auto found = cases.all[c].finding_on(lanes);
    if (!found) continue;
    return {Outcome::End::killed, cases.all[c].name, found->clock, signal_of(shape, *found)};
  }
  return {};
}

std::string text_of(const Outcome& o) {
  return fmt::format("{}, clock {}, {}", o.stimulus, o.clock, o.signal);
}

template <class Trait>
void expect_the_same_together_and_alone() {
  const Rtl<Trait> rtl;
  constexpr unsigned count = 60;
  const Planted planted(rtl.source(), count);
  std::vector<unsigned> numbers(planted.mutants().size() + 1);
  std::iota(numbers.begin(), numbers.end(), 0U);
  const PlantedNets nets =
      planted_nets(rtl.bench, planted.nets({numbers.begin() + 1, numbers.end()}));
  const auto batch = batch_of(rtl.bench, nets, {numbers.begin() + 1, numbers.end()});
  std::map<unsigned, Outcome> killed;
  for (std::size_t c = 0; c < some_cases; ++c) {
    batch->run(rtl.cases.all[c], [&](unsigned k, const Outcome& o) { killed[k] = o; });
  }
  StreamLanes lanes(nets, rtl.bench.shape(), numbers);
  for (const unsigned k : numbers) {
    EXPECT_EQ(text_of(killed[k]), text_of(alone(lanes, rtl.bench.shape(), k, rtl.cases)))
        << rtl.bench.title() << ": " << (k == 0 ? "none" : planted.mutants()[k - 1]);
  }
  const auto found = std::count_if(killed.begin(), killed.end(), [](const auto& one) {
    return one.second.end == Outcome::End::killed;
  });
  EXPECT_GT(found, count / 2);
}

TEST_F(StreamMutants, AreKilledTogetherAsAlone) {
  expect_the_same_together_and_alone<OfPairs<0>>();
  expect_the_same_together_and_alone<OfCrosses<0>>();
  expect_the_same_together_and_alone<OfSerial>();
}

template <class Trait>
std::string said_of_faulty() {
  const Rtl<Trait> rtl;
  const Subject subject(rtl.bench, rtl.cases, rtl.source(), 1);
  return test::error_of(
      [&] { subject.attack({1}, 0, rtl.cases.quick, 1, [](unsigned, Outcome) {}); });
}

TEST_F(StreamMutants, AreNotAttackedWhereTheRtlDiffersWithoutOne) {
  const std::string said = "RTL and model differ without a mutant: random transactions, case ";
  EXPECT_NE(said_of_faulty<OfPairs<1>>().find("pairs FAULT=1: " + said), std::string::npos);
  EXPECT_NE(said_of_faulty<OfCrosses<1>>().find("crosses FAULT=1: " + said), std::string::npos);
}

// The numbers of those at such a pin.
std::vector<unsigned> mutants_at(const Subject& subject, const std::string& pin) {
  std::vector<unsigned> numbers;
  for (unsigned k = 1; k <= subject.mutants().size(); ++k) {
    if (subject.mutants()[k - 1].find("-port " + pin + ' ') != std::string::npos) {
      numbers.push_back(k);
    }
  }
  return numbers;
}

template <class Trait>
std::tuple<std::size_t, std::size_t> planted_and_killed(const std::string& pin) {
  const Rtl<Trait> rtl;
  const Subject subject(rtl.bench, rtl.cases, rtl.source(), most_mutants);
  const std::vector<unsigned> numbers = mutants_at(subject, pin);
  std::size_t killed = 0;
  if (!numbers.empty()) {
    subject.attack(numbers, 0, rtl.cases.quick, 1, [&](unsigned, const Outcome&) { ++killed; });
  }
  return {numbers.size(), killed};
}

// Of four registers; a clock of several is no pin in the nets. A reset that never comes leaves what
// powered up: two registers say valid.
TEST_F(StreamMutants, OfClocksAndOfResetsAtOnceAreKilled) {
  EXPECT_EQ(planted_and_killed<OfPairs<0>>("CLK"), std::tuple(12, 12));
  EXPECT_EQ(planted_and_killed<OfPairs<0>>("ARST"), std::tuple(6, 6));
  EXPECT_EQ(planted_and_killed<OfCrosses<0>>("CLK"), std::tuple(0, 0));
}

}  // namespace
}  // namespace cosim::mutation
