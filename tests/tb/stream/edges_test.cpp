#include "tb/stream/runner.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "tb/stream/shape.h"
#include "tests/support/error_of.h"

namespace cosim {
namespace {

TEST(Edges, SomeClockAlwaysHasOneAndEachInTheEnd) {
  EdgesDrawn edges(3);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    edges.start(seed);
    std::array<int, 3> waited{};
    for (int step = 0; step < 5000; ++step) {
      const std::vector<Word>& now = edges.step();
      ASSERT_NE(now[0] + now[1] + now[2], 0U);
      for (std::size_t c = 0; c < 3; ++c) {
        waited[c] = now[c] != 0 ? 0 : waited[c] + 1;
        ASSERT_LT(waited[c], 400) << "clock " << c << " stands still, seed " << seed;
      }
    }
  }
}

// Of two: together, alone, and each several times between two of the other.
TEST(Edges, AllOrdersCome) {
  EdgesDrawn edges(2);
  edges.start(1);
  std::string all;
  for (int step = 0; step < 20000; ++step) {
    const std::vector<Word>& now = edges.step();
    all += static_cast<char>('0' + now[0] + 2 * now[1]);
  }
  for (const char* order :
       {"3333333", "111111111", "222222222", "12121212", "13", "31", "23", "32", "121122"}) {
    EXPECT_NE(all.find(order), std::string::npos) << order;
  }
}

TEST(Edges, AreThoseOfTheSeed) {
  EdgesDrawn one(2), again(2);
  one.step();  // of another case, before
  one.start(5);
  again.start(5);
  for (int step = 0; step < 1000; ++step) ASSERT_EQ(one.step(), again.step()) << step;
}

TEST(Edges, ARoundIsOverWhenEachClockHasHadOne) {
  EdgesDrawn edges(2);
  edges.start(3);
  std::array<bool, 2> had{};
  for (int step = 0; step < 5000; ++step) {
    const std::vector<Word>& now = edges.step();
    for (std::size_t c = 0; c < 2; ++c) had[c] = had[c] || now[c] != 0;
    ASSERT_EQ(edges.all_were(), had[0] && had[1]) << step;
    if (had[0] && had[1]) had = {};
  }
}

// ---- The clock of an interface ----

std::string refusal_of(const char* clock) {
  StreamShape shape;
  shape.title = "made";
  shape.set_clocks("", "w_clk\nfalling r_clk\n");
  const Field data{"data", 8, Format::bits, "", "", 0, "data"};
  return test::error_of([&] { shape.add({.name = "x", .clock = clock}, true, {&data, 1}); });
}

TEST(ClockOfAStream, IsOneOfThoseOfTheDesign) {
  EXPECT_EQ(refusal_of("r_clk"), "");
  EXPECT_EQ(refusal_of("clk"), "made: stream x: clock(\"clk\"): the design has no such clock");
  EXPECT_EQ(refusal_of(nullptr),
            "made: stream x: the design has several clocks; name that of the stream with "
            "clock(\"PORT\")");
}

TEST(ClockOfAStream, OfADesignWithOneNeedNotBeSaid) {
  StreamShape shape;
  shape.set_clocks("clk", "");
  const Field data{"data", 8, Format::bits, "", "", 0, "data"};
  shape.add({.name = "x"}, true, {&data, 1});
  shape.add({.name = "y", .clock = "clk"}, false, {&data, 1});
  EXPECT_EQ(shape.in.front().clock, 0U);
  EXPECT_EQ(shape.out.front().clock, 0U);
}

}  // namespace
}  // namespace cosim
