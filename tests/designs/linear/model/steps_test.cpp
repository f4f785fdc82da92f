// The steps that words say, in order.
#include <gtest/gtest.h>

#include <string>

#include "tests/designs/linear/records.h"

namespace cosim::linear {
namespace {

// The last word of Table 3 of the source, and a word of 64 steps.
TEST(LineSteps, ComeLeftmostFirst) {
  const auto steps = [](const Params& p, Word major, Word minor) {
    std::string text;
    const auto out = record_of<Outputs<Word>>(Shown{.minor = minor, .major = major});
    for_each_step(p, out, [&](Word dx, Word dy) {
      EXPECT_EQ(dx, 1);
      text += dy == 1 ? '/' : '-';
    });
    return text;
  };
  EXPECT_EQ(steps(of(5, 2), 0b11100000, 0b01000000), "-/-");
  EXPECT_EQ(steps(of(5, 2), 0, 0), "");
  EXPECT_EQ(steps(of(32, 26), ~Word{0}, Word{1} << 63), "/" + std::string(63, '-'));
}

}  // namespace
}  // namespace cosim::linear
