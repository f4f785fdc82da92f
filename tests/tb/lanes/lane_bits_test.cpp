// What is put into a lane is what it holds, and no other lane.
#include "tb/lanes/lane_bits.h"

#include <gtest/gtest.h>

#include "model/core/value.h"
#include "tb/util/random.h"

namespace cosim::lanes {
namespace {

TEST(LaneBits, AreThoseThatWerePut) {
  Random random(7);
  for (int i = 0; i < 200; ++i) {
    const std::size_t words = 1 + random.below(8), lane = random.below(64 * words);
    std::vector<int> widths;
    std::vector<Word> codes;
    std::size_t bits = 0;
    for (std::size_t n = random.below(20); codes.size() < n;) {
      const auto width = static_cast<int>(random.below(65));
      widths.push_back(width);
      codes.push_back(static_cast<Word>(random.next()));
      bits += static_cast<std::size_t>(width);
    }
    const Packed packed(widths);
    ASSERT_EQ(packed.words(), (bits + 63) / 64);
    std::vector<std::uint64_t> all(packed.words() + 1, 1), planes(bits * words);
    packed.pack(codes, all.data());
    EXPECT_EQ(all.back(), 1U);  // untouched
    packed.put(all.data(), planes.data(), words, lane);
    std::vector<Word> held(codes.size());
    packed.get(planes.data(), words, lane, held);
    for (std::size_t c = 0; c < codes.size(); ++c) {
      ASSERT_EQ(held[c], widths[c] == 0 ? 0 : low_bits(codes[c], widths[c])) << widths[c];
    }
    for (std::size_t p = 0; p < planes.size(); ++p) {
      const std::uint64_t own = std::uint64_t{1} << (lane % 64);
      ASSERT_EQ(planes[p] & ~(p % words == lane / 64 ? own : 0), 0U);
    }
  }
}

}  // namespace
}  // namespace cosim::lanes
