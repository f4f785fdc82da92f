#include "model/linear/oracle.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace cosim::linear {
namespace {

// The source's example: m = 5, gamma = 3. The minor word of a full tick is ROM 2's seven positions
// and the multiplier's one, here 0.
TEST(LinearOracleMinorWord, IsTable1) {
  const std::vector<std::uint64_t> table = {0b0000000, 0b0001000, 0b0100010, 0b0101010,
                                            0b1010101, 0b1011101, 0b1110111, 0b1111111};
  for (std::uint64_t address = 0; address < 8; ++address) {
    const Words words = words_at(5, 3, {31, address << 2}, 0);
    EXPECT_EQ(words.minor, table[address] << 1) << "address " << address;
  }
}

TEST(LinearOracleMajorWord, IsTable2) {
  const std::vector<std::uint64_t> table = {0b00000000, 0b10000000, 0b11000000, 0b11100000,
                                            0b11110000, 0b11111000, 0b11111100, 0b11111110};
  for (std::uint64_t remainder = 0; remainder < 8; ++remainder) {
    const Line line{static_cast<std::int64_t>(8 + remainder), 0};
    EXPECT_EQ(words_at(5, 3, line, 0).major, 0b11111111U);
    EXPECT_EQ(words_at(5, 3, line, 1).major, table[remainder]) << "remainder " << remainder;
  }
}

TEST(LinearOracleWords, AreTable3) {
  const Line line{27, 0b01010};
  ASSERT_EQ(ticks(3, line.major), 4);
  EXPECT_EQ(words_at(5, 3, line, 0), (Words{0b11111111, 0b01000101}));
  EXPECT_EQ(words_at(5, 3, line, 1), (Words{0b11111111, 0b01000100}));
  EXPECT_EQ(words_at(5, 3, line, 2), (Words{0b11111111, 0b01000101}));
  EXPECT_EQ(words_at(5, 3, line, 3), (Words{0b11100000, 0b01000000}));
}

TEST(LinearOracleMinorStepsAt, FollowsTheBitOfThePosition) {
  // 1 = 2^0 * 1 by a_1, 2 by a_2, 3 by a_1, 4 by a_3, 6 = 2 * 3 by a_2, 12 = 4 * 3 by a_3.
  EXPECT_TRUE(minor_steps_at(3, 0b100, 1));
  EXPECT_TRUE(minor_steps_at(3, 0b010, 2));
  EXPECT_TRUE(minor_steps_at(3, 0b100, 3));
  EXPECT_TRUE(minor_steps_at(3, 0b001, 4));
  EXPECT_TRUE(minor_steps_at(3, 0b010, 6));
  EXPECT_TRUE(minor_steps_at(3, 0b001, 12));
  EXPECT_FALSE(minor_steps_at(3, 0b011, 5));
  EXPECT_FALSE(minor_steps_at(3, 0b111, 8));  // a_4 of three bits
  EXPECT_FALSE(minor_steps_at(3, 0b111, 0));
}

// Every line of every shape up to 6 bits, cut into words: the positions come out in order, once,
// and no tick more or less.
TEST(LinearOracleWords, AreThePositionsInOrder) {
  for (int m = 1; m <= 6; ++m) {
    for (int gamma = 0; gamma <= m; ++gamma) {
      for (std::int64_t major = 0; major >> m == 0; ++major) {
        for (Code code = 0; code >> m == 0; ++code) {
          const Line line{major, code};
          const int width = 1 << gamma;
          std::int64_t major_sum = 0, minor_sum = 0, tick = 0, q = 0;
          for (; q < major; ++tick) {
            const Words words = words_at(m, gamma, line, tick);
            major_sum += std::popcount(words.major);
            minor_sum += std::popcount(words.minor);
            for (int p = width - 1; p >= 0; --p) {
              ++q;
              ASSERT_EQ(words.major >> p & 1, q <= major ? 1U : 0U);
              ASSERT_EQ(words.minor >> p & 1, q <= major && minor_steps_at(m, code, q) ? 1U : 0U);
            }
          }
          ASSERT_EQ(major_sum, major);
          ASSERT_EQ(minor_sum, minor_steps(m, major, code));
          ASSERT_EQ(ticks(gamma, major), tick);
          ASSERT_EQ(words_at(m, gamma, line, tick), Words{});
        }
      }
    }
  }
}

TEST(LinearOracleWords, FillSixtyFourBits) {
  EXPECT_EQ(words_at(8, 6, {65, 0xff}, 0), (Words{~std::uint64_t{0}, ~std::uint64_t{0}}));
  EXPECT_EQ(words_at(8, 6, {65, 0xff}, 1), (Words{std::uint64_t{1} << 63, std::uint64_t{1} << 63}));
}

TEST(LinearOracleWords, AreTotal) {
  using Limits = std::numeric_limits<std::int64_t>;
  EXPECT_EQ(words_at(5, 3, {27, 31}, -1), Words{});
  EXPECT_EQ(words_at(5, 3, {27, 31}, Limits::max()), Words{});
  EXPECT_EQ(words_at(5, 7, {27, 31}, 0), Words{});
  EXPECT_EQ(ticks(-1, 27), 0);
  EXPECT_EQ(ticks(3, Limits::min()), 0);
  EXPECT_EQ(ticks(6, Limits::max()), std::int64_t{1} << 57);
  EXPECT_EQ(words_at(5, 6, {Limits::max(), 0}, (std::int64_t{1} << 57) - 1).major,
            ~std::uint64_t{1});
  EXPECT_FALSE(minor_steps_at(99, ~Code{0}, 1));
  EXPECT_FALSE(minor_steps_at(std::numeric_limits<int>::min(), 7, 1));
  EXPECT_FALSE(minor_steps_at(3, 7, -1));
  EXPECT_FALSE(minor_steps_at(3, 7, Limits::min()));
}

}  // namespace
}  // namespace cosim::linear
