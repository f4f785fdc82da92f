// The steps that words say, in order, and words whose bits are in the other order.
#include "model/linear/steps.h"

#include <gtest/gtest.h>

#include <string>

#include "model/linear/reversed.h"

namespace cosim::linear {
namespace {

// The last word of Table 3 of the source, and a word of 64 steps.
TEST(LineSteps, ComeLeftmostFirst) {
  const auto steps = [](const Params& p, Word major, Word minor) {
    Outputs<Word> out;
    out.major = major;
    out.minor = minor;
    std::string text;
    Way sum;
    for_each_step(p, out, [&](Word dx, Word dy) {
      EXPECT_EQ(dx, 1);
      text += dy == 1 ? '/' : '-';
      sum.x += dx;
      sum.y += dy;
    });
    const Way way = way_of(out);
    EXPECT_EQ(way.x, sum.x);
    EXPECT_EQ(way.y, sum.y);
    return text;
  };
  EXPECT_EQ(steps({5, 2}, 0b11100000, 0b01000000), "-/-");
  EXPECT_EQ(steps({5, 2}, 0, 0), "");
  EXPECT_EQ(steps({32, 26}, ~Word{0}, Word{1} << 63), "/" + std::string(63, '-'));
}

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
