// What cases a design with a stream model meets.
#include "tb/stream/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "model/core/input_error.h"
#include "tests/support/error_of.h"

namespace cosim {
namespace {

// A stream in and one out; the columns of a case are x_give, x_stall, x_data, y_stall, y_waits.
class Shape {
 public:
  Shape() {
    const Field data{"data", 8, Format::bits, "", "", 0, "data"};
    shape.title = "drawn";
    shape.add({.name = "x"}, true, {&data, 1});
    shape.add({.name = "y"}, false, {&data, 1});
  }
  StreamShape shape;
};

struct Stalls {
  std::size_t some = 0;  // rows that have one
  Word most = 0;
};
Stalls stalls(const Stimulus& s, std::size_t column) {
  Stalls all;
  for (const auto& row : s.clocks) {
    all.some += row[column] != 0 ? 1 : 0;
    all.most = std::max(all.most, row[column]);
  }
  return all;
}

bool any(std::size_t, std::span<const Word>) { return true; }

TEST(StreamDraw, CasesHaveNoStallsManyDensitiesAndOneSideThatStarvesTheOther) {
  const Shape s;
  int none = 0, x_starves = 0, y_starves = 0, y_shut = 0, y_waits = 0, y_waits_at_times = 0;
  std::set<std::size_t> densities;  // in tenths
  for (std::uint64_t i = 0; i < 400; ++i) {
    const Stimulus drawn = draw_stream_case(s.shape, 1, i, 1000, any);
    const std::size_t rows = drawn.clocks.size();
    if (rows < 16) continue;
    const Stalls x = stalls(drawn, 1), y = stalls(drawn, 3);
    none += x.some == 0 && y.some == 0 ? 1 : 0;
    x_starves += x.some == rows && x.most >= 8 && y.some == 0 ? 1 : 0;
    y_starves += y.some == rows && y.most >= 8 && x.some == 0 ? 1 : 0;
    y_shut += y.most > 100 ? 1 : 0;
    const std::size_t waits = stalls(drawn, 4).some;
    y_waits += waits == rows ? 1 : 0;
    y_waits_at_times += waits > 0 && waits < rows ? 1 : 0;
    densities.insert(10 * x.some / rows);
  }
  EXPECT_GE(none, 20);
  EXPECT_GE(x_starves, 10);
  EXPECT_GE(y_starves, 10);
  EXPECT_GE(y_shut, 5);
  EXPECT_GE(densities.size(), 6U);
  // Who takes looks for valid first, in a quarter of the cases, with stalls or without.
  EXPECT_GE(y_waits, 20);
  EXPECT_GE(y_waits_at_times, 10);
  EXPECT_LE(y_waits + y_waits_at_times, 150);
}

TEST(StreamDraw, ACaseFollowsFromItsNumberAndGivesOnlyWhatIsLegal) {
  const Shape s;
  const auto even = [](std::size_t, std::span<const Word> words) { return words[0] % 2 == 0; };
  const Stimulus drawn = draw_stream_case(s.shape, 1, 7, 1000, even);
  EXPECT_EQ(drawn.clocks, draw_stream_case(s.shape, 1, 7, 1000, even).clocks);
  EXPECT_NE(drawn.clocks, draw_stream_case(s.shape, 1, 8, 1000, even).clocks);
  for (const auto& row : drawn.clocks) EXPECT_EQ(row[2] % 2, 0);
  const auto never = [](std::size_t, std::span<const Word>) { return false; };
  EXPECT_THROW(draw_stream_case(s.shape, 1, 7, 1000, never), InputError);
}

constexpr const char* names[] = {"red", "green", "blue"};

// A stream of a color, which has names, and a number of 8 bits in two's complement.
class Rules {
 public:
  Rules() {
    Field color{"color", 2, Format::number, "", "", 0, "color"};
    color.names = names;
    color.named = 3;
    const Field level{"level", 8, Format::twos_complement, "", "", 0, "level"};
    const Field cells[] = {color, level};
    shape.title = "drawn";
    shape.add({.name = "x"}, true, cells);
  }
  Interface& x() { return shape.in.front(); }
  // The values of cell c in many cases.
  std::vector<Word> drawn(std::size_t c) {
    std::vector<Word> all;
    for (std::uint64_t i = 0; i < 400; ++i) {
      for (const auto& row : draw_stream_case(shape, 1, i, 1000, {}).clocks) {
        all.push_back(row[2 + c]);
      }
    }
    return all;
  }
  StreamShape shape;
};

double share_of(const std::vector<Word>& all, Word value) {
  return static_cast<double>(std::ranges::count(all, value)) / static_cast<double>(all.size());
}

TEST(StreamDraw, EachNameOfAFieldIsAsOftenAsAnyOther) {
  const auto all = Rules().drawn(0);
  for (Word color = 0; color < 3; ++color) EXPECT_NEAR(share_of(all, color), 1.0 / 3, 0.02);
  EXPECT_EQ(share_of(all, 3), 0);
}

TEST(StreamDraw, WeightsAreTheSharesOfValuesAndRanges) {
  using clocked::Share;
  Rules r;
  r.shape.draw(r.x(), 1, std::vector<Share>{{-3}, {5, 8, 2}, clocked::any(1)});
  const auto all = r.drawn(1);
  EXPECT_NEAR(share_of(all, 0xfd), 0.25, 0.02);
  double range = 0;
  for (Word level = 5; level <= 8; ++level) range += share_of(all, level);
  EXPECT_NEAR(range, 0.5, 0.03);
  EXPECT_NEAR(share_of(all, 6), 0.125, 0.02);
  EXPECT_GT(share_of(all, 100), 0);
}

TEST(StreamDraw, ARuleThatNoValueKeepsIsRefused) {
  using Shares = std::vector<clocked::Share>;
  const auto why = [](std::size_t cell, const Shares& shares) {
    Rules r;
    return test::error_of([&] { r.shape.draw(r.x(), cell, shares); });
  };
  EXPECT_EQ(why(1, {{128}}), "drawn: draws() of x_level: 128 is no value of it");
  EXPECT_EQ(why(1, {{-129, 0, 1}}), "drawn: draws() of x_level: -129 is no value of it");
  EXPECT_EQ(why(0, {{3}}), "drawn: draws() of x_color: 3 is no value of it");
  EXPECT_EQ(why(1, {{4, 3, 1}}), "drawn: draws() of x_level: 4 is above 3");
  EXPECT_NE(why(1, {{4, 0}}), "");
  EXPECT_EQ(why(1, {{-128, 127, 1}}), "");
}

TEST(StreamDraw, WhatIsArrangedIsWhatGoesIn) {
  Rules r;
  r.x().arrange = [](std::span<Word> words) { words[1] = words[0] + 1; };
  const auto colors = r.drawn(0), levels = r.drawn(1);
  for (std::size_t i = 0; i < colors.size(); ++i) ASSERT_EQ(levels[i], colors[i] + 1);
}

TEST(StreamDraw, ACaseIsAsLongAsTheModelSays) {
  Rules r;
  r.shape.most_transactions = 8;
  std::size_t longest = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    longest = std::max(longest, draw_stream_case(r.shape, 1, i, 1000, {}).clocks.size());
  }
  EXPECT_EQ(longest, 8U);
}

}  // namespace
}  // namespace cosim
