#include "model/linear/reversed.h"

#include <gtest/gtest.h>

namespace cosim::linear {
namespace {

TEST(Reversed, LastBitFirst) {
  for (int width = 1; width <= 32; ++width) {
    const Word step = width <= 12 ? 1 : ones(width) / 997;  // all values, or a thousand of them
    for (Word v = 0; v <= ones(width); v += step) {
      Word expected = 0;
      for (int i = 0; i < width; ++i) {
        if (bit(v, i)) expected += Word{1} << (width - 1 - i);
      }
      ASSERT_EQ(reversed(v, width), expected) << v << " of " << width << " bits";
    }
  }
}

}  // namespace
}  // namespace cosim::linear
