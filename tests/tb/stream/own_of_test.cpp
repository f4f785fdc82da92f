// A driver of a design's own may keep the record that it was given.
#include "tb/stream/own_of.h"

#include <gtest/gtest.h>

#include <array>
#include <utility>

namespace cosim {
namespace {

struct Params {
  int width = 16;
};
#define KEPT_BITS(FIELD) FIELD(data, p.width, bits, "", "what goes in")
COSIM_RECORD(Kept, KEPT_BITS, Params);

/// Drives the record that it was given first, and reads it through the pointer alone.
struct Keeper {
  void drive(const Kept<Word>* kept, std::span<Word> pins) {
    if (kept != nullptr && first == nullptr) first = kept;
    given = kept;
    pins[0] = first == nullptr ? 0 : first->data;
    pins[1] = given == nullptr ? 0 : given->data;
  }
  bool took(std::span<const Word> pins) { return pins[0] != 0; }

  const Kept<Word>*first = nullptr, *given = nullptr;
};

// So deep in the stack that what a record in a frame of drive() was is written over.
[[gnu::noinline]] Word written_over(int depth) {
  volatile Word noise[64];
  for (auto& one : noise) one = ~Word{0};
  return depth == 0 ? noise[7] : noise[9] + written_over(depth - 1);
}

TEST(OwnDriver, KeepsARecordUntilTheCaseEnds) {
  const Params p;
  detail::OwnGiverOf<Keeper, Kept<Word>> own(p);
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

}  // namespace
}  // namespace cosim
