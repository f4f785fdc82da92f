// Numbers in ones' complement, against their definitions tried out digit by digit.
#include <gtest/gtest.h>

#include <utility>

#include "model/clocked/model.h"
#include "tests/support/codes.h"

namespace cosim::circular {
namespace {

using clocked::Int, clocked::OnesComplement, clocked::UInt;
using test::modulo, test::ones_complement_value;

// Calls visit.operator()<width>() for each width.
template <int least, int most, class Visit>
void for_each_width(const Visit& visit) {
  [&]<int... more>(std::integer_sequence<int, more...>) {
    (visit.template operator()<least + more>(), ...);
  }
  (std::make_integer_sequence<int, most - least + 1>());
}

template <int width>
Word minus_zero_code(Word v) {
  return static_cast<Word>(OnesComplement<width, true>(Int<width>(v)).code());
}
template <int width>
Word wrapped(Word v) {
  return static_cast<Word>(OnesComplement<width>(Int<width + 2>(v)));
}

TEST(MinusZero, IsTheOnlyZeroOfItsCodes) {
  for_each_width<2, 9>([]<int width>() {
    const Word half = Word{1} << (width - 1);
    for (Word v = -half + 1; v < half; ++v) {
      const Word code = minus_zero_code<width>(v);
      ASSERT_EQ(low_bits(code, width), code) << v << " width " << width;
      ASSERT_EQ(ones_complement_value(code, width), v) << "width " << width;
    }
  });
  for_each_width<2, 63>(
      []<int width>() { EXPECT_EQ(minus_zero_code<width>(0), ones(width)) << width; });
}

TEST(WrapEndAround, IsTheNearestNumberModuloTwoToTheWidthLessOne) {
  for_each_width<2, 8>([]<int width>() {
    const Word modulus = (Word{1} << width) - 1;
    const Word bound = Word{1} << (width - 1);
    for (Word v = -modulus + 1; v < modulus; ++v) {
      const Word number = wrapped<width>(v);
      ASSERT_EQ(modulo(number, modulus), modulo(v, modulus)) << v << " width " << width;
      ASSERT_LT(number, bound) << v << " width " << width;
      ASSERT_GT(number, -bound) << v << " width " << width;
    }
  });
}

// An adder whose carry out comes back in, on the codes themselves.
TEST(WrapEndAround, IsWhatAnEndAroundCarryDoes) {
  for_each_width<2, 6>([]<int width>() {
    for (Word a = 0; a >> width == 0; ++a) {
      for (Word b = 0; b >> width == 0; ++b) {
        const Word sum = a + b;
        const Word code = ((sum & ((Word{1} << width) - 1)) + (sum >> width)) & ones(width);
        const auto number = [](Word of) {
          return OnesComplement<width>::from_code(UInt<width>(of));
        };
        const OnesComplement<width> total = number(a) + number(b);
        ASSERT_EQ(static_cast<Word>(total), ones_complement_value(code, width))
            << a << " + " << b << " width " << width;
      }
    }
  });
}

}  // namespace
}  // namespace cosim::circular
