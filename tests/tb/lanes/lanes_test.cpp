// Lanes against what they replace: the Verilated class and the model on words, register by
// register; the sums of the one-case sweep; and a fault in any lane, on any clock.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <map>
#include <vector>

#include "tb/lanes/player.h"
#include "tb/sim/sweep.h"
#include "tb/util/parallel.h"
#include "tb/util/process.h"
#include "tests/support/designs.h"
#include "tests/support/in_lanes.h"
#include "tests/support/sanitized.h"
#include "tests/support/sweeps.h"
#include "tests/tb/shape.h"

namespace cosim::test {
namespace {

constexpr std::uint64_t kSeed = 5;
constexpr std::uint64_t kLength = 1000;

// Of the smallest shape of a design, which takes a second or two to compile.
template <class Design>
const Bench<Design>& smallest() {
  return *benches_of<Design>().front();
}
const lanes::Built& lanes_of(const AnyBench& bench, int lanes) {
  static std::map<std::pair<std::string, int>, std::unique_ptr<lanes::Built>> known;
  auto& built = known[{bench.title(), lanes}];
  if (!built) built = in_lanes(bench, lanes);
  return *built;
}

Word code_in(const lanes::Player& player, const std::vector<std::size_t>& planes,
             std::size_t lane) {
  Word code = 0;
  for (std::size_t b = 0; b < planes.size(); ++b) {
    if (player.bit(planes[b], lane)) code |= shift_left(1, static_cast<int>(b));
  }
  return code;
}

template <class Design>
class LanesOf : public testing::Test {};
TYPED_TEST_SUITE(LanesOf, Designs, DesignNames);

// Cases of their own on random clocks, each in its lane.
TYPED_TEST(LanesOf, HoldWhatRtlAndModelHold) {
  using Design = TypeParam;
  const Bench<Design>& bench = smallest<Design>();
  const lanes::Built& built = lanes_of(bench, 512);
  const auto& layout = built.layout;
  const auto p = bench.params();
  const auto state_fields = Design::template State<Word>::fields(p);
  Random random(11);
  for (int i = 0; i < 60; ++i) {
    const std::uint64_t first = random.below(1000), clocks = random.below(kLength);
    const auto lane = static_cast<std::size_t>(random.below(512));
    SCOPED_TRACE("case " + std::to_string(first + lane) + " clock " + std::to_string(clocks));
    lanes::Player player(built, smallest<TypeParam>());
    player.begin(kSeed, first, 512);
    ASSERT_FALSE(player.run(clocks));

    const HostileCase c{kSeed, first + lane, clocks};
    HostileStimulus<Design> hostile(p, c);
    const auto both = bench.lockstep(c.power_up());
    typename Design::template Inputs<Word> in;
    while (hostile.next(in, {})) ASSERT_TRUE(both->clock(in));
    const auto registers = to_words(both->dut().registers());
    ASSERT_EQ(registers.size(), layout.registers.size());
    for (std::size_t r = 0; r < registers.size(); ++r) {
      ASSERT_EQ(code_in(player, layout.registers[r], lane), registers[r]) << "register " << r;
    }
    std::size_t plane = layout.state;
    const auto state = to_words(both->state());
    for (std::size_t s = 0; s < state.size(); ++s) {
      std::vector<std::size_t> planes;
      for (int b = 0; b < state_fields[s].width; ++b) planes.push_back(plane++);
      ASSERT_EQ(code_in(player, planes, lane), low_bits(state[s], state_fields[s].width))
          << state_fields[s].name;
    }
  }
}

// One bit of one register turned over in one lane, on a clock in the middle and on the last.
TYPED_TEST(LanesOf, FindAFaultInAnyLane) {
  for (const int lanes : {512, 64}) {
    const lanes::Built& built = lanes_of(smallest<TypeParam>(), lanes);
    lanes::Player player(built, smallest<TypeParam>());
    for (const std::size_t lane : {0U, 1U, 63U, 64U, 255U, 511U}) {
      if (lane >= static_cast<std::size_t>(lanes)) continue;
      for (const std::uint64_t clock : {std::uint64_t{400}, kLength - 1}) {
        for (const auto& planes : built.layout.registers) {
          player.begin(kSeed, 77, static_cast<std::uint64_t>(lanes));
          ASSERT_FALSE(player.run(clock));
          player.flip(planes.back(), lane);
          const auto found = player.run(kLength);
          ASSERT_TRUE(found);
          EXPECT_EQ(found->lane, lane);
          EXPECT_EQ(found->clock, clock);
        }
      }
    }
  }
}

TYPED_TEST(LanesOf, DoNotCompareALaneThatIsNotAtWork) {
  const lanes::Built& built = lanes_of(smallest<TypeParam>(), 512);
  lanes::Player player(built, smallest<TypeParam>());
  player.begin(kSeed, 0, 70);
  player.flip(built.layout.registers.front().front(), 70);
  EXPECT_FALSE(player.run(1));
  player.work_below(64);
  player.flip(built.layout.registers.front().front(), 64);
  EXPECT_FALSE(player.run(2));
  player.flip(built.layout.registers.front().front(), 63);
  EXPECT_TRUE(player.run(3));
}

// For any number of clocks, lanes and threads, and wherever it was interrupted.
TYPED_TEST(LanesOf, SumUpToTheSweepOfOneCaseAtATime) {
  const AnyBench& bench = smallest<TypeParam>();
  for (const std::uint64_t clocks : {1ULL, 1000ULL, 63'001ULL, 512'000ULL, 700'123ULL}) {
    const Result alone = expect_match(hostile_sweep(bench, kSeed, clocks));
    for (const int lanes : {512, 64}) {
      const Sweep sweep = lanes::hostile_sweep(bench, lanes_of(bench, lanes), kSeed, clocks);
      for (const unsigned threads : {1U, 2U, 5U}) {
        for (const std::uint64_t done : {0ULL, 1ULL, 63ULL}) {
          if (done >= sweep.cases) continue;
          Resume resume;
          resume.done.cases = done;
          resume.done.clocks = 1000 * done;
          const Result together = run_sweep(sweep, threads, {}, resume);
          EXPECT_TRUE(together.match());
          EXPECT_EQ(together.cases, alone.cases);
          EXPECT_EQ(together.clocks, alone.clocks);
          EXPECT_EQ(together.clocks, clocks);
        }
      }
    }
  }
}

// In seconds where the processor has vectors; where it has none, or what they reach is counted,
// fewer.
TYPED_TEST(LanesOf, MatchOnTenThousandMillionClocks) {
  const int lanes = lanes::widest();
  std::uint64_t clocks = lanes == 512 ? 10'000'000'000 : lanes == 256 ? 2'000'000'000 : 100'000'000;
  if (slow) clocks /= 100;
  const AnyBench& bench = smallest<TypeParam>();
  const Result result =
      expect_match(lanes::hostile_sweep(bench, lanes_of(bench, lanes), 1, clocks));
  EXPECT_EQ(result.clocks, clocks);
}

// A shape's lanes are compiled once, by the one of them that asks first.
TYPED_TEST(LanesOf, AreKept) {
  const Scratch scratch;
  const auto written = [&] {
    std::vector<std::pair<std::filesystem::path, std::filesystem::file_time_type>> times;
    for (const auto& entry : std::filesystem::directory_iterator(scratch.path())) {
      if (entry.path().extension() == ".so") {
        times.emplace_back(entry.path(), entry.last_write_time());
      }
    }
    return times;
  };
  const auto [machine, source] = machine_of(smallest<TypeParam>());
  std::array<decltype(written()), 3> after;
  in_parallel(after.size(), after.size(), [&, machine = machine, source = source](std::size_t i) {
    lanes::built(machine->title, machine->played(), source, 64, scratch.path());
    after.at(i) = written();
    return true;
  });
  for (const auto& times : after) {
    EXPECT_EQ(times.size(), 1U);
    EXPECT_EQ(times, written());
  }
}

}  // namespace
}  // namespace cosim::test
