// The operations of models on machine integers, against their definitions tried out bit by bit.
#include "model/core/value.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/codes.h"

namespace cosim {
namespace {

constexpr Word kLeast = std::numeric_limits<Word>::min();
constexpr Word kGreatest = std::numeric_limits<Word>::max();

using test::modulo, test::ones_complement_value;

TEST(LowBits, KeepBelowAndClearAbove) {
  for (const Word v : {Word{0}, Word{1}, Word{-1}, kLeast, kGreatest, Word{0x0123456789abcdef}}) {
    for (int width = 1; width <= 64; ++width) {
      const Word low = low_bits(v, width);
      for (int i = 0; i < 64; ++i) {
        ASSERT_EQ(low >> i & 1, i < width ? v >> i & 1 : 0) << v << " width " << width;
      }
    }
  }
  EXPECT_EQ(low_bits(kLeast, 64), kLeast);
  EXPECT_EQ(low_bits(-1, 63), kGreatest);
}

TEST(Wrap, IsModuloAPowerOfTwo) {
  for (int width = 1; width <= 7; ++width) {
    for (Word v = -300; v <= 300; ++v) ASSERT_EQ(wrap(v, width), modulo(v, Word{1} << width));
  }
}

TEST(Ones, AreAllBits) {
  Word expected = 0;
  for (int n = 1; n <= 63; ++n) {
    expected = 2 * expected + 1;
    EXPECT_EQ(ones(n), expected);
  }
  EXPECT_EQ(ones(64), -1);
}

TEST(Bit, IsTwosComplementBelowZero) {
  EXPECT_TRUE(bit(5, 0));
  EXPECT_FALSE(bit(5, 1));
  EXPECT_TRUE(bit(5, 2));
  EXPECT_FALSE(bit(-2, 0));
  EXPECT_TRUE(bit(-2, 63));
  EXPECT_TRUE(bit(kLeast, 63));
  EXPECT_FALSE(bit(kGreatest, 63));
}

TEST(Shift, RightIsTheFloor) {
  for (Word v = -40; v <= 40; ++v) {
    for (int n = 0; n < 8; ++n) {
      const Word divisor = Word{1} << n;
      ASSERT_EQ(shift_right(v, n) * divisor, v - modulo(v, divisor)) << v << " >> " << n;
    }
    EXPECT_EQ(shift_right(v, 63), v < 0 ? -1 : 0);
  }
}

TEST(Shift, LeftMultipliesModuloTheWord) {
  for (Word v = -40; v <= 40; ++v) {
    for (int n = 0; n < 8; ++n) ASSERT_EQ(shift_left(v, n), v * (Word{1} << n));
    EXPECT_EQ(shift_left(v, 63), v % 2 == 0 ? 0 : kLeast);
  }
  EXPECT_EQ(shift_left(kGreatest, 1), -2);
}

TEST(Condition, SelectsFlagsAndTests) {
  EXPECT_EQ(select(true, Word{3}, Word{4}), 3);
  EXPECT_EQ(select(false, Word{3}, Word{4}), 4);
  EXPECT_EQ(flag<Word>(true), 1);
  EXPECT_EQ(flag<Word>(false), 0);
  EXPECT_TRUE(is_set(Word{1}));
  EXPECT_FALSE(is_set(Word{0}));
}

TEST(Either, RunsOnlyTheSideThatHolds) {
  int ran = 0;
  const auto one = [&] { return ++ran, Word{1}; };
  const auto two = [&] { return ran += 10, Word{2}; };
  EXPECT_EQ(if_else(true, one, two), 1);
  EXPECT_EQ(ran, 1);
  EXPECT_EQ(if_else(false, one, two), 2);
  EXPECT_EQ(ran, 11);
}

TEST(TwosComplement, CodesStandForTheirNumbers) {
  for (int width = 1; width <= 9; ++width) {
    const Word half = Word{1} << (width - 1);
    for (Word v = -half; v < half; ++v) {
      ASSERT_EQ(from_twos_complement(low_bits(v, width), width), v) << "width " << width;
    }
  }
  EXPECT_EQ(from_twos_complement(ones(63), 63), -1);
}

TEST(OnesComplement, CodesStandForTheirNumbers) {
  for (int width = 2; width <= 9; ++width) {
    for (Word code = 0; code >> width == 0; ++code) {
      ASSERT_EQ(from_ones_complement(code, width), ones_complement_value(code, width))
          << code << " width " << width;
    }
  }
}

TEST(OnesComplement, NumbersComeBackFromTheirCodes) {
  for (int width = 2; width <= 9; ++width) {
    const Word half = Word{1} << (width - 1);
    for (Word v = -half + 1; v < half; ++v) {
      const Word code = to_ones_complement(v, width);
      ASSERT_EQ(low_bits(code, width), code) << v << " width " << width;
      ASSERT_EQ(ones_complement_value(code, width), v) << "width " << width;
    }
  }
}

TEST(OnesComplement, HasTwoZeros) {
  for (int width = 2; width <= 63; ++width) {
    EXPECT_EQ(to_ones_complement(Word{0}, width), 0);
    EXPECT_EQ(from_ones_complement(ones(width), width), 0);
    EXPECT_EQ(from_ones_complement(Word{0}, width), 0);
  }
}

// Models are evaluated at compile time too.
static_assert(low_bits(-1, 64) == -1 && ones(64) == -1);

}  // namespace
}  // namespace cosim
