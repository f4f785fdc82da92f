#include "model/circular/arc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "model/circular/oracle.h"
#include "model/core/wide.h"

namespace cosim::circular {
namespace {

constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();

// The n >= 0 with the least |n - sqrt(q)|, by trying them.
std::int64_t tried_root(std::int64_t q) {
  if (q <= 0) return 0;
  const double root = std::sqrt(static_cast<double>(q));
  std::int64_t n = 0;
  while (std::abs(static_cast<double>(n + 1) - root) < std::abs(static_cast<double>(n) - root)) ++n;
  return n;
}

std::vector<Point> points_next_to(std::uint64_t radius2) {
  std::vector<Point> points;
  const std::int64_t last = nearest_root(radius2);
  for (std::int64_t y = 0; y <= last; ++y) {
    const Point p{nearest_on(y, radius2), y};
    if (p.x > p.y) points.push_back(p);
  }
  for (std::int64_t x = last; x >= 0; --x) {
    const Point p{x, nearest_on(x, radius2)};
    if (p.y >= p.x) points.push_back(p);
  }
  return points;
}

std::vector<Point> walk(Point p, std::uint64_t radius2) {
  std::vector<Point> points = {p};
  for (const Point end = end_point(radius2); !(p == end); points.push_back(p)) {
    p = next_point(p, radius2);
  }
  return points;
}

// The steps to the first point that stands level with `target` or past it.
std::int64_t walked_steps_to(const std::vector<Point>& walk, Point target) {
  std::int64_t steps = 0;
  for (const Point& p : walk) {
    const bool changed = p.x <= p.y;
    if (target.x > target.y ? changed || p.y >= target.y : changed && p.x <= target.x) break;
    ++steps;
  }
  return steps;
}

TEST(ArcNearestRoot, IsTheNearest) {
  for (std::int64_t q = 0; q < 3000; ++q) {
    ASSERT_EQ(nearest_root(static_cast<std::uint64_t>(q)), tried_root(q)) << q;
  }
}

// (n + 1/2)^2 = n^2 + n + 1/4: n^2 + n still rounds to n, n^2 + n + 1 to n + 1.
TEST(ArcNearestRoot, ChangesBetweenSquaresOfHalvesAtEverySize) {
  std::vector<std::uint64_t> roots = {2, 3, 94906265, 94906266, 0xffff'fffe, 0xffff'ffff};
  std::mt19937_64 random(1665343);
  for (int n = 0; n < 2000; ++n) roots.push_back(random() >> (32 + random() % 30) | 2);
  for (const std::uint64_t n : roots) {
    const auto root = static_cast<std::int64_t>(n);
    ASSERT_EQ(nearest_root(n * n - n), root - 1);
    ASSERT_EQ(nearest_root(n * n - n + 1), root);
    ASSERT_EQ(nearest_root(n * n - 1), root);  // as a double it rounds to n^2
    ASSERT_EQ(nearest_root(n * n), root);
    ASSERT_EQ(nearest_root(n * n + n), root);
    ASSERT_EQ(nearest_root(n * n + n + 1), root + 1);
  }
  EXPECT_EQ(nearest_root(kLargest), std::int64_t{1} << 32);
}

TEST(ArcNextToCircle, IsTheNearestAlongTheAxisThatRests) {
  for (std::int64_t q = 1; q <= 400; ++q) {
    for (std::int64_t x = -1; x <= 22; ++x) {
      for (std::int64_t y = -1; y <= 22; ++y) {
        const bool nearest =
            x >= 0 && y >= 0 && (x > y ? x == tried_root(q - y * y) : y == tried_root(q - x * x));
        ASSERT_EQ(next_to_circle({x, y}, static_cast<std::uint64_t>(q)), nearest)
            << "(" << x << ", " << y << ") radius2 " << q;
      }
    }
  }
}

// F has the fraction 3/4: 4 floor(F) + 3 = 4 F, an integer by either formula of the source.
TEST(ArcSetup, IsTheFormulasOfTheSource) {
  for (std::int64_t q : {1, 2, 144, 1000}) {
    for (std::int64_t x = 0; x < 40; ++x) {
      for (std::int64_t y = 0; y < 40; ++y) {
        const auto s = setup({x, y}, static_cast<std::uint64_t>(q));
        const std::int64_t f1 = 4 * q - (2 * x - 1) * (2 * x - 1) - 4 * (y + 1) * (y + 1);
        const std::int64_t f2 = 4 * q - 4 * (x - 1) * (x - 1) - (2 * y + 1) * (2 * y + 1);
        ASSERT_EQ(s.sector2, y >= x);
        ASSERT_EQ(4 * s.f + 3, y >= x ? f2 : f1);
        ASSERT_EQ(s.ct7, y >= x ? x - 1 : y);
        ASSERT_EQ(s.ct8, y >= x ? x - y : x - y - 1);
      }
    }
  }
}

TEST(ArcSetup, IsThePrintedStart) {
  const auto start = setup({12, 0}, 144);  // F = 10.75, CT7 = 0, CT8 = 11
  EXPECT_EQ(start.f, 10);
  EXPECT_EQ(start.ct7, 0);
  EXPECT_EQ(start.ct8, 11);
  EXPECT_FALSE(start.sector2);
  const auto after_change = setup({8, 9}, 144);  // F = 4.75, CT7 = 7, CT8 = -1
  EXPECT_EQ(after_change.f, 4);
  EXPECT_EQ(after_change.ct7, 7);
  EXPECT_EQ(after_change.ct8, -1);
  EXPECT_TRUE(after_change.sector2);
}

TEST(ArcSetup, FromTheAxisIsTheRadiusLess125) {
  for (std::int64_t r : {std::int64_t{1}, std::int64_t{4095}, std::int64_t{0xffff'ffff}}) {
    const auto radius2 = static_cast<std::uint64_t>(r) * static_cast<std::uint64_t>(r);
    EXPECT_EQ(setup({r, 0}, radius2).f, r - 2);  // R - 1.25 = (R - 2) + .75
  }
}

TEST(ArcStepsTo, IsThatOfAWalkFromEveryStartToEveryPoint) {
  std::vector<std::uint64_t> circles;
  for (std::uint64_t r = 1; r <= 60; ++r) circles.push_back(r * r);
  for (std::uint64_t radius2 = 2; radius2 <= 2000; ++radius2) circles.push_back(radius2);
  for (const std::uint64_t radius2 : circles) {
    const std::vector<Point> points = points_next_to(radius2);
    for (const Point& from : points) {
      const std::vector<Point> walked = walk(from, radius2);
      const auto to_end = static_cast<std::int64_t>(walked.size()) - 1;
      ASSERT_EQ(steps_to_end(from, radius2), to_end)
          << "radius2 " << radius2 << " from (" << from.x << ", " << from.y << ")";
      for (const Point& target : points) {
        const std::int64_t steps = steps_to(from, radius2, target);
        ASSERT_EQ(steps, walked_steps_to(walked, target))
            << "radius2 " << radius2 << " from (" << from.x << ", " << from.y << ") to ("
            << target.x << ", " << target.y << ")";
        const bool ahead = target.y >= from.y && target.x <= from.x;
        if (ahead) {
          ASSERT_EQ(walked[static_cast<std::size_t>(steps)], target);
        } else {
          ASSERT_EQ(steps, 0);
        }
      }
    }
  }
}

TEST(ArcStepsTo, IsThatOfAWalkToAnyTarget) {
  for (std::uint64_t radius2 = 1; radius2 <= 150; ++radius2) {
    for (const Point& from : points_next_to(radius2)) {
      const std::vector<Point> walked = walk(from, radius2);
      for (std::int64_t x = 0; x < 16; ++x) {
        for (std::int64_t y = 0; y < 16; ++y) {
          ASSERT_EQ(steps_to(from, radius2, {x, y}), walked_steps_to(walked, {x, y}));
        }
      }
    }
  }
}

// Walks of a few thousand steps across the diagonal of big circles, and to their ends.
TEST(ArcStepsTo, HoldsForBigCircles) {
  std::mt19937_64 random(34);
  std::vector<std::uint64_t> circles = {kLargest, kLargest - 1, std::uint64_t{0xffff'fffe} << 32};
  for (int n = 0; n < 60; ++n) circles.push_back((random() | std::uint64_t{1} << 40) >> (n % 20));
  for (const std::uint64_t radius2 : circles) {
    const auto diagonal =
        static_cast<std::int64_t>(std::sqrt(static_cast<long double>(radius2) / 2.0L));
    const std::int64_t row = diagonal - static_cast<std::int64_t>(random() % 500) - 3;
    Point p{nearest_on(row, radius2), row};
    const Point from = p;
    const std::int64_t to_end = steps_to_end(from, radius2);
    for (std::int64_t step = 0; step < 1500; ++step, p = next_point(p, radius2)) {
      ASSERT_TRUE(next_to_circle(p, radius2));
      ASSERT_EQ(steps_to(from, radius2, p), step) << "radius2 " << radius2;
      ASSERT_EQ(steps_to_end(p, radius2), to_end - step) << "radius2 " << radius2;
    }
    ASSERT_LE(p.x, p.y) << "the walk is to cross the diagonal";
    ASSERT_EQ(steps_to_end(p, radius2), p.x);
  }
}

TEST(ArcEndPoint, IsOnTheAxis) {
  EXPECT_EQ(end_point(144), (Point{0, 12}));
  EXPECT_EQ(end_point(156), (Point{0, 12}));  // 12.5^2 = 156.25
  EXPECT_EQ(end_point(157), (Point{0, 13}));
  EXPECT_EQ(end_point(kLargest), (Point{0, std::int64_t{1} << 32}));
}

TEST(ArcWidthNeeded, HoldsTheRoundedRadius) {
  EXPECT_EQ(width_needed(1), 1);
  EXPECT_EQ(width_needed(4), 2);
  EXPECT_EQ(width_needed(std::uint64_t{255} * 255), 8);
  EXPECT_EQ(width_needed(65280), 8);  // 255.5^2 = 65280.25
  EXPECT_EQ(width_needed(65281), 9);
  EXPECT_EQ(width_needed(std::uint64_t{4095} * 4095), 12);
  EXPECT_EQ(width_needed(kLargest), 33);
}

// Far from the circle F wraps at 2^64; nothing overflows.
TEST(ArcArithmetic, IsTotal) {
  constexpr std::int64_t kMin = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
  for (const std::uint64_t radius2 : {std::uint64_t{0}, std::uint64_t{1}, kLargest}) {
    for (const std::int64_t x : {kMin, kMin + 1, std::int64_t{-1}, std::int64_t{0}, kMax}) {
      for (const std::int64_t y : {kMin, kMin + 1, std::int64_t{-1}, std::int64_t{0}, kMax}) {
        const Int128 wide = x > y ? Int128{x} - y - 1 : Int128{x} - y;
        EXPECT_EQ(setup({x, y}, radius2).ct8, static_cast<std::int64_t>(wide));
        EXPECT_FALSE(next_to_circle({x, y}, radius2) && (x != 0 || y != 0));
        const std::int64_t steps = steps_to({x, y}, radius2, {y, x});
        EXPECT_GE(steps, 0);
        EXPECT_LE(steps, steps_to_end({x, y}, radius2));
      }
    }
  }
  EXPECT_EQ(nearest_on(kMin, kLargest), 0);
}

}  // namespace
}  // namespace cosim::circular
