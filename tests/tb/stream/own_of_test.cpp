// A driver of a design's own: what it sees, and that it may keep the record that it was given.
#include "tb/stream/own_of.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>

#include "tb/stream/shape.h"

namespace cosim {
namespace {

struct Kept {
  clocked::UInt<16> data;
};

/// Drives the record that it was given first, and reads it through the pointer alone.
struct Keeper {
  struct Drives {
    clocked::UInt<16> kept, now;
  };
  struct Reads {
    clocked::Bit takes;
  };
  Drives drive(const Kept* kept) {
    if (kept != nullptr && first == nullptr) first = kept;
    const auto data = [](const Kept* one) {
      return one == nullptr ? clocked::UInt<16>(0) : one->data;
    };
    return {data(first), data(kept)};
  }
  bool took(const Reads& pins) { return bool(pins.takes); }

  const Kept* first = nullptr;
};

// So deep in the stack that what a record in a frame of drive() was is written over.
[[gnu::noinline]] Word written_over(int depth) {
  volatile Word noise[64];
  for (auto& one : noise) one = ~Word{0};
  return depth == 0 ? noise[7] : noise[9] + written_over(depth - 1);
}

TEST(OwnDriver, KeepsARecordUntilTheCaseEnds) {
  detail::OwnGiverOf<Keeper, Kept> own;
  std::array<Word, 2> pins{};
  const auto drives = [&](Word word) {
    const std::span<const Word> words(&word, 1);
    own.drive(&words, pins);
    written_over(16);
    return std::pair(pins[0], pins[1]);
  };
  const auto took = [&](Word value) { return own.took({&value, 1}); };

  own.drive(nullptr, pins);
  EXPECT_EQ(drives(77), std::pair(Word{77}, Word{77}));
  EXPECT_FALSE(took(0));
  // The harness offers it until it has gone in; the same record, where it was.
  EXPECT_EQ(drives(77), std::pair(Word{77}, Word{77}));
  EXPECT_TRUE(took(1));
  own.drive(nullptr, pins);
  EXPECT_EQ(pins[0], 77);
  for (Word next = 100; next < 1000; ++next) {
    ASSERT_EQ(drives(next), std::pair(Word{77}, next));
    ASSERT_TRUE(took(1));
  }
}

// What each kind of field is in a case, at its port, and as a number.
TEST(OwnDriver, ItsPinsAndTransactionsAreCodes) {
  struct Group {
    clocked::Bit on;
    clocked::Array<clocked::Int<4>, 2> few;
  };
  struct All {
    Group group;
    clocked::OnesComplement<5> ones;
    clocked::At<"elsewhere", clocked::UInt<100>> wide;
  };
  using Codes = detail::Codes<All>;
  std::vector<std::string> labels, ports;
  StreamShape shape;
  shape.add({.name = "x"}, false, Codes::fields());
  for (const Field& f : shape.out[0].cells) {
    labels.push_back(label_of(f));
    ports.push_back(f.net);
  }
  EXPECT_EQ(labels, (std::vector<std::string>{"x_group.on", "x_group.few[0]", "x_group.few[1]",
                                              "x_ones", "x_wide[63:0]", "x_wide[99:64]"}));
  EXPECT_EQ(ports, (std::vector<std::string>{"x_group_on", "x_group_few", "x_group_few", "x_ones",
                                             "elsewhere", "elsewhere"}));
  const All all{{1, {-1, 7}}, -3, clocked::UInt<100>(5) << 64 | 9};
  std::array<Word, 6> words{};
  Codes::put(all, words);
  EXPECT_EQ(words, (std::array<Word, 6>{1, 15, 7, 28, 9, 5}));
  const All again = Codes::object(words);
  EXPECT_TRUE(again.group.few[0] == -1 && again.group.few[1] == 7 && again.ones == -3);
  EXPECT_TRUE(again.group.on && again.wide == all.wide);
}

}  // namespace
}  // namespace cosim
