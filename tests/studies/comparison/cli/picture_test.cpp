// What the pictures of cosim compare show, against the geometry of the work.
#include "tests/cli/picture.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

namespace cosim::cli {
namespace {

using Points = std::set<std::pair<long, long>>;

const char* const kOnTheCurve = "44,123,182";  // the colour of no deviation

// A line, a line along an axis, and a quarter of R = 12 about (8, 8), clockwise.
Picture of_program(const std::string& algorithms) {
  const Folder folder;
  const std::string file =
      folder.write("a.ngc", "G21 G90\nG1 X8 Y4 F100\nG1 X8 Y20\nG2 X20 Y8 I0 J-12\n");
  return Picture({"compare", file, "--steps-per-mm", "1", "--algorithms", algorithms});
}

// The points of the grid nearest to the quarter, along the row below 45 degrees, else the column.
Points nearest_to_the_quarter() {
  Points points;
  for (long line = 0; line <= 12; ++line) {
    const long across = std::lround(std::sqrt(144.0 - static_cast<double>(line * line)));
    if (across < line) continue;
    points.insert({8 + across, 8 + line});
    points.insert({8 + line, 8 + across});
  }
  return points;
}

double off(std::pair<long, long> at) {
  return std::fabs(std::hypot(at.first - 8, at.second - 8) - 12);
}

// Dots as points of the grid, when the leftmost is at x = left, the lowest at y = low and both
// axes have as many pixels a step as x has from left to right.
std::vector<std::pair<long, long>> on_grid(const std::vector<Dot>& dots, long left, long right,
                                           long low) {
  double x0 = dots.at(0).x, x1 = x0, y0 = dots.at(0).y;
  for (const Dot& d : dots) {
    x0 = std::min(x0, d.x), x1 = std::max(x1, d.x), y0 = std::max(y0, d.y);
  }
  const double scale = (x1 - x0) / static_cast<double>(right - left);
  std::vector<std::pair<long, long>> points;
  for (const Dot& d : dots) {
    const double x = (d.x - x0) / scale, y = (y0 - d.y) / scale;
    EXPECT_NEAR(x, std::round(x), 0.01);
    EXPECT_NEAR(y, std::round(y), 0.01);
    points.emplace_back(left + std::lround(x), low + std::lround(y));
  }
  return points;
}

// Where it lies in the plane, with axes alike, and blue only where it is on the circle.
TEST(Picture, OfAProgramsArc) {
  if (!can_plot()) GTEST_SKIP() << "no gnuplot";
  const Picture picture = of_program("midpoint,single-axis");
  const std::vector<Dot> dots = picture.path(0);
  ASSERT_FALSE(dots.empty());
  const auto points = on_grid(dots, 8, 20, 8);
  const Points expected = nearest_to_the_quarter();
  EXPECT_EQ(Points(points.begin(), points.end()), expected);
  for (std::size_t i = 0; i < dots.size(); ++i) {
    EXPECT_EQ(dots[i].colour == kOnTheCurve, off(points[i]) == 0)
        << points[i].first << ", " << points[i].second;
  }
  double largest = 0, squares = 0;
  for (const auto& at : expected) {
    largest = std::max(largest, off(at));
    squares += off(at) * off(at);
  }
  std::ostringstream title;
  title << std::fixed << std::setprecision(3) << "midpoint: max " << largest << ", RMS "
        << std::sqrt(squares / static_cast<double>(expected.size()));
  EXPECT_TRUE(picture.has(title.str())) << title.str();
  EXPECT_EQ(picture.path(1).size(), 25U);  // 12 steps on each axis
}

// The arc's points begin where the lines' end; the curve goes through (0, 0), (8, 4) and (8, 20),
// and from there keeps 12 steps off (8, 8) up to (20, 8).
TEST(Picture, OfAProgramIsOfOnePiece) {
  if (!can_plot()) GTEST_SKIP() << "no gnuplot";
  const Picture picture = of_program("bresenham,midpoint");
  const std::vector<Dot> lines = picture.path(0), curve = picture.curve();
  ASSERT_EQ(lines.size(), 25U);
  ASSERT_GT(curve.size(), 12U);
  double left = lines[0].x, low = lines[0].y, high = low, top_of_arc = low;
  for (const Dot& d : lines) {
    left = std::min(left, d.x), low = std::max(low, d.y), high = std::min(high, d.y);
  }
  const double step = (low - high) / 20;
  for (const Dot& d : picture.path(1)) top_of_arc = std::min(top_of_arc, d.y);
  EXPECT_NEAR(top_of_arc, high, 0.1);
  const auto expect_at = [&](const Dot& d, double x, double y) {
    EXPECT_NEAR((d.x - left) / step, x, 0.01);
    EXPECT_NEAR((low - d.y) / step, y, 0.01);
  };
  expect_at(curve[0], 0, 0);
  expect_at(curve[1], 8, 4);
  expect_at(curve[2], 8, 20);
  expect_at(curve.back(), 20, 8);
  for (std::size_t i = 2; i < curve.size(); ++i) {
    const double x = (curve[i].x - left) / step - 8, y = (low - curve[i].y) / step - 8;
    EXPECT_NEAR(std::hypot(x, y), 12, 0.01);
    EXPECT_GE(std::min(x, y), -0.01);
  }
}

// 8 + 16 steps of lines, then 17 of the arc: each where it lies on the whole path.
TEST(Picture, HasTheStepsAlongThePath) {
  if (!can_plot()) GTEST_SKIP() << "no gnuplot";
  const Picture picture = of_program("dda,bresenham,midpoint");
  EXPECT_TRUE(picture.has("dda: max"));
  EXPECT_TRUE(picture.has("bresenham (lines): max"));
  EXPECT_TRUE(picture.has("midpoint (arcs): max"));
  std::vector<double> starts, steps, ends;
  for (const int panel : {1, 2}) {
    std::vector<double> x;
    for (const Dot& d : picture.bars(panel)) x.push_back(d.x - 400 * panel);
    ASSERT_FALSE(x.empty());
    const auto [low, high] = std::minmax_element(x.begin(), x.end());
    starts.push_back(*low);
    ends.push_back(*high);
    steps.push_back((*high - *low) / (panel == 1 ? 24 : 17));
  }
  EXPECT_NEAR(ends[0], starts[1], 0.5);
  EXPECT_NEAR(steps[0], steps[1], 0.1);
  // The DDA draws both: its panel ends where the arcs do.
  double last = 0;
  for (const Dot& d : picture.bars(0)) last = std::max(last, d.x);
  EXPECT_NEAR(last, ends[1], 0.5);
}

// Of the printed line's 28 points each is there, in a panel for each algorithm.
TEST(Picture, HasEveryAlgorithm) {
  if (!can_plot()) GTEST_SKIP() << "no gnuplot";
  const Picture picture({"compare", "--line", "27,9"});
  int panel = 0;
  for (const char* name :
       {"su1631518", "su1631518-greedy", "rate-multiplier", "dda", "dda-half", "bresenham"}) {
    EXPECT_TRUE(picture.has(std::string(">") + name + ": max")) << name;
    EXPECT_GE(picture.path(panel++).size(), 28U) << name;
  }
}

// A third of the points is on the line, but nowhere on 80 steps, which share a pixel, all are.
TEST(Picture, ShowsTheWorstOfAPixel) {
  if (!can_plot()) GTEST_SKIP() << "no gnuplot";
  const Picture picture({"compare", "--line", "30000,10000", "--algorithms", "bresenham"});
  const std::vector<Dot> bars = picture.bars(0), path = picture.path(0);
  EXPECT_GT(bars.size(), 100U);
  EXPECT_LT(bars.size(), 1000U);
  EXPECT_LT(path.size(), 1000U);
  std::set<std::string> colours;
  std::size_t on_the_line = 0;
  for (const Dot& d : bars) {
    colours.insert(d.colour);
    on_the_line += d.colour == kOnTheCurve;
  }
  EXPECT_LE(on_the_line, 1U);  // the end
  EXPECT_LE(colours.size(), 2U);
}

}  // namespace
}  // namespace cosim::cli
