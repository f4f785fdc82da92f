// The stimulus that knows no manners: the same for the same seed, on every pin, within every width.
#include "tb/sim/hostile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "tests/support/model_machine.h"
#include "tests/support/shapes.h"

namespace cosim::test {
namespace {

template <class Design>
using InputsOf = typename Design::template Inputs<Word>;
template <class Design>
using Stream = std::vector<Words<InputsOf<Design>>>;

template <class Design>
Stream<Design> stream(const typename Design::Params& p, const HostileCase& c) {
  Stream<Design> all;
  HostileStimulus<Design> hostile(p, c);
  for (InputsOf<Design> in; hostile.next(in, {});) all.push_back(to_words(in));
  return all;
}

template <class Design>
class HostileStimulusOf : public testing::Test {};
TYPED_TEST_SUITE(HostileStimulusOf, Designs, DesignNames);

TYPED_TEST(HostileStimulusOf, ACaseIsAlwaysTheSame) {
  for_each_shape<TypeParam>([](const auto& p) {
    EXPECT_EQ(stream<TypeParam>(p, {9, 4, 3000}), stream<TypeParam>(p, {9, 4, 3000}));
  });
}

TYPED_TEST(HostileStimulusOf, OtherCasesAndSeedsAreOthers) {
  for_each_shape<TypeParam>([](const auto& p) {
    std::set<Stream<TypeParam>> streams;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      for (std::uint64_t index = 0; index < 25; ++index) {
        streams.insert(stream<TypeParam>(p, {seed, index, 300}));
      }
    }
    EXPECT_EQ(streams.size(), 100U);
  });
}

TYPED_TEST(HostileStimulusOf, AShorterCaseIsTheBeginningOfALonger) {
  for_each_shape<TypeParam>([](const auto& p) {
    Stream<TypeParam> longer = stream<TypeParam>(p, {9, 4, 3000});
    longer.resize(700);
    EXPECT_EQ(stream<TypeParam>(p, {9, 4, 700}), longer);
  });
}

TYPED_TEST(HostileStimulusOf, HasTheClocksAsked) {
  for_each_shape<TypeParam>([](const auto& p) {
    for (const std::uint64_t clocks : {0U, 1U, 255U, 256U, 1000U}) {
      EXPECT_EQ(stream<TypeParam>(p, {1, 0, clocks}).size(), clocks);
    }
  });
}

// Both levels of every pin; of a bus, every bit at both, and its ends.
TYPED_TEST(HostileStimulusOf, MovesEveryBitOfEveryPin) {
  for_each_shape<TypeParam>([](const auto& p) {
    const auto fields = InputsOf<TypeParam>::fields(p);
    Words<InputsOf<TypeParam>> high{}, low{};
    std::vector<std::set<Word>> seen(fields.size());
    for (std::uint64_t index = 0; index < 50; ++index) {
      for (const auto& in : stream<TypeParam>(p, {1, index, 1000})) {
        for (std::size_t i = 0; i < in.size(); ++i) {
          ASSERT_EQ(in[i], low_bits(in[i], fields[i].width)) << fields[i].name;
          high[i] |= in[i];
          low[i] |= low_bits(~in[i], fields[i].width);
          seen[i].insert(in[i]);
        }
      }
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
      EXPECT_EQ(high[i], ones(fields[i].width)) << fields[i].name;
      EXPECT_EQ(low[i], ones(fields[i].width)) << fields[i].name;
      EXPECT_EQ(seen[i].count(0), 1U) << fields[i].name;
      EXPECT_EQ(seen[i].count(ones(fields[i].width)), 1U) << fields[i].name;
    }
  });
}

// In some stretches work goes on for long, in others the machine is hardly let go.
TYPED_TEST(HostileStimulusOf, LetsTheMachineWorkAndDisturbsIt) {
  for_each_shape<TypeParam>([](const auto& p) {
    int longest = 0, begun = 0;
    for (std::uint64_t index = 0; index < 400; ++index) {
      ModelMachine<TypeParam> machine(p);
      int run = 0;
      HostileStimulus<TypeParam> hostile(p, {1, index, 1000});
      InputsOf<TypeParam> in;
      for (typename TypeParam::template Outputs<Word> o{}; hostile.next(in, o);) {
        o = machine.clock(in);
        run = to_words(o)[0] != 0 ? run + 1 : 0;  // busy, running
        begun += run == 1;
        longest = std::max(longest, run);
      }
    }
    EXPECT_GT(begun, 2000);  // 5 in a case
    // As long as the shape allows: 2^n words of a line, of an arc as many steps as its width
    // counts.
    const int bits = TypeParam::parameters(p).back().value;
    EXPECT_GE(longest, std::min(shift_left(1, bits), Word{40}));
  });
}

}  // namespace

TEST(Random, IsSplitMix64) {
  Random random(0);
  // The first numbers of the published generator from state 0.
  EXPECT_EQ(random.next(), 0xe220a8397b1dcdafULL);
  EXPECT_EQ(random.next(), 0x6e789e6aa1b965f4ULL);
  EXPECT_EQ(random.next(), 0x06c45d188009454fULL);
}

TEST(Random, BelowIsBelowAndReachesEveryNumber) {
  Random random(1);
  for (const std::uint64_t n : {1U, 2U, 3U, 7U, 40U}) {
    std::set<std::uint64_t> seen;
    for (int i = 0; i < 2000; ++i) seen.insert(random.below(n));
    EXPECT_EQ(seen.size(), n);
    EXPECT_EQ(*seen.rbegin(), n - 1);
  }
}

TEST(Random, OneInPowerHalvesWithEachPower) {
  Random random(1);
  for (int n = 0; n <= 6; ++n) {
    int hits = 0;
    constexpr int kTries = 64'000;
    for (int i = 0; i < kTries; ++i) hits += random.one_in_power(n);
    const double expected = kTries / static_cast<double>(1 << n);
    EXPECT_NEAR(hits, expected, 6 * std::sqrt(expected) * (n != 0)) << n;
  }
}

TEST(Random, CornersFitAndReachTheEnds) {
  Random random(1);
  for (const int width : {1, 2, 5, 32, 63, 64}) {
    std::set<Word> seen;
    for (int i = 0; i < 50'000; ++i) {
      const Word v = random.corner(width);
      ASSERT_EQ(v, low_bits(v, width));
      seen.insert(v);
    }
    for (const Word end : {Word{0}, Word{1}, ones(width), low_bits(-2, width)}) {
      EXPECT_EQ(seen.count(end), 1U) << width;
    }
    for (int b = 0; b < width; ++b) {
      EXPECT_EQ(seen.count(shift_left(1, b)), 1U) << "bit " << b << " of " << width;
    }
  }
}

}  // namespace cosim::test
