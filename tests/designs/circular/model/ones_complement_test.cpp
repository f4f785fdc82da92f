// The registers in ones' complement, against their definitions tried out digit by digit.
#include "model/circular/ones_complement.h"

#include <gtest/gtest.h>

#include "tests/support/codes.h"

namespace cosim::circular {
namespace {

using test::modulo, test::ones_complement_value;

TEST(MinusZero, IsTheOnlyZeroOfItsCodes) {
  for (int width = 2; width <= 9; ++width) {
    const Word half = Word{1} << (width - 1);
    for (Word v = -half + 1; v < half; ++v) {
      const Word code = to_ones_complement_minus_zero(v, width);
      ASSERT_EQ(low_bits(code, width), code) << v << " width " << width;
      ASSERT_EQ(ones_complement_value(code, width), v) << "width " << width;
    }
  }
  for (int width = 2; width <= 63; ++width) {
    EXPECT_EQ(to_ones_complement_minus_zero(Word{0}, width), ones(width));
  }
}

TEST(WrapEndAround, IsTheNearestNumberModuloTwoToTheWidthLessOne) {
  for (int width = 2; width <= 8; ++width) {
    const Word modulus = (Word{1} << width) - 1;
    const Word bound = Word{1} << (width - 1);
    for (Word v = -modulus + 1; v < modulus; ++v) {
      const Word wrapped = wrap_end_around(v, width);
      ASSERT_EQ(modulo(wrapped, modulus), modulo(v, modulus)) << v << " width " << width;
      ASSERT_LT(wrapped, bound) << v << " width " << width;
      ASSERT_GT(wrapped, -bound) << v << " width " << width;
    }
  }
}

// An adder whose carry out comes back in, on the codes themselves.
TEST(WrapEndAround, IsWhatAnEndAroundCarryDoes) {
  for (int width = 2; width <= 6; ++width) {
    for (Word a = 0; a >> width == 0; ++a) {
      for (Word b = 0; b >> width == 0; ++b) {
        const Word sum = a + b;
        const Word code = ((sum & ((Word{1} << width) - 1)) + (sum >> width)) & ones(width);
        ASSERT_EQ(
            wrap_end_around(from_ones_complement(a, width) + from_ones_complement(b, width), width),
            ones_complement_value(code, width))
            << a << " + " << b << " width " << width;
      }
    }
  }
}

// Models are evaluated at compile time too.
static_assert(wrap_end_around(Word{8}, 4) == -7 && wrap_end_around(Word{-8}, 4) == 7);

}  // namespace
}  // namespace cosim::circular
