// What cases a design with a stream model meets.
#include "tb/stream/draw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "model/core/input_error.h"

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

}  // namespace
}  // namespace cosim
