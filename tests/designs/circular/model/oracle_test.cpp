#include "model/circular/oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

namespace cosim::circular {
namespace {

// The table of the source, stepped: F by its recurrences alone, with the correction where the
// sector changes, so that setup() and next_point() are checked by something that knows neither.
struct Recurrence {
  Point p;
  std::int64_t f = 0;  // floor(F)
  bool sector2 = false;
  std::int64_t least = f;  // of F, between the step's own update and the correction too
  std::int64_t greatest = f;

  void add(std::int64_t change) {
    f += change;
    least = std::min(least, f);
    greatest = std::max(greatest, f);
  }

  void step() {
    const bool diagonal = sector2 == (f >= 0);
    if (sector2 || diagonal) --p.x;
    if (!sector2 || diagonal) ++p.y;
    if (diagonal) {
      add(2 * (p.x - p.y) - 1);
    } else {
      add(sector2 ? 2 * p.x - 1 : -(2 * p.y + 1));
    }
    if (!sector2 && p.x <= p.y) {
      sector2 = true;
      add(p.x + p.y);  // 2X, or 2X + 1 where Y = X + 1
    }
  }
};

Recurrence start(Point p, std::uint64_t radius2) {
  const Setup s = setup(p, radius2);
  return {p, s.f, s.sector2};
}

// Every point next to the circle.
template <class Visit>
void for_each_start(std::uint64_t radius2, Visit visit) {
  const std::int64_t last = nearest_root(radius2);
  for (std::int64_t t = 0; t <= last; ++t) {
    const Point in_row{nearest_on(t, radius2), t};
    const Point in_column{t, nearest_on(t, radius2)};
    if (in_row.x > in_row.y) visit(in_row);
    if (in_column.y >= in_column.x) visit(in_column);
  }
}

// The whole walk of the recurrence against next_point() and setup(); its last state.
Recurrence checked_walk(Point from, std::uint64_t radius2) {
  Recurrence machine = start(from, radius2);
  while (machine.p.x > 0) {
    const Point next = next_point(machine.p, radius2);
    machine.step();
    EXPECT_EQ(next, machine.p) << "radius2 " << radius2;
    EXPECT_EQ(setup(next, radius2).f, machine.f) << "radius2 " << radius2;
    EXPECT_EQ(setup(next, radius2).sector2, machine.sector2) << "radius2 " << radius2;
    EXPECT_TRUE(next_to_circle(next, radius2)) << "radius2 " << radius2;
    if (testing::Test::HasFailure()) break;  // one is enough to read
  }
  return machine;
}

// '|' a step in Y, '-' in X, '/' in both.
std::string path(Point p, std::uint64_t radius2) {
  std::string steps;
  while (p.x > 0) {
    const Point next = next_point(p, radius2);
    steps += next.x == p.x ? '|' : next.y == p.y ? '-' : '/';
    p = next;
  }
  return steps;
}

TEST(CircularOracleNextPoint, DrawsTheTableOfTheSource) {
  EXPECT_EQ(path({12, 0}, 144), "|||/|/|///-/-/---");
}

// Radius 14 changes sector at X = Y by a diagonal. By
// hand: 13.96, 13.86, 13.67, 13.42, 13.08, 12.65, 12.12, 11.49, 10.72 and 9.80 on rows 1 to 10,
// then 10.72 in column 9.
TEST(CircularOracleNextPoint, ChangesSectorByADiagonalToTheDiagonal) {
  Point p{14, 0};
  for (const std::int64_t x : {14, 14, 14, 13, 13, 13, 12, 11, 11, 10}) {
    p = next_point(p, 196);
    EXPECT_EQ(p.x, x);
  }
  EXPECT_EQ(p, (Point{10, 10}));
  EXPECT_EQ(next_point(p, 196), (Point{9, 11}));
}

// Radius 23: 16.52 on row 16 and 15.49 on row 17. The step is to 16, the nearest of column 16.
TEST(CircularOracleNextPoint, NeverMovesTwoAcrossTheDiagonal) {
  EXPECT_EQ(next_point({17, 16}, 529), (Point{16, 17}));
  EXPECT_EQ(next_point({16, 17}, 529), (Point{15, 17}));
}

TEST(CircularOracleNextPoint, StaysAtTheEnd) {
  EXPECT_EQ(next_point({0, 12}, 144), (Point{0, 12}));
  constexpr std::int64_t kMin = std::numeric_limits<std::int64_t>::min();
  constexpr std::int64_t kMax = std::numeric_limits<std::int64_t>::max();
  EXPECT_EQ(next_point({kMin, kMin}, 144), (Point{kMin, kMin}));
  EXPECT_EQ(next_point({kMax, kMax}, 144), (Point{kMax - 1, kMax}));
  EXPECT_EQ(next_point({kMax, kMin}, 144), (Point{kMax - 1, kMin + 1}));
}

TEST(CircularOracleNextPoint, IsThatOfTheRecurrenceFromEveryStart) {
  for (std::uint64_t radius2 = 1; radius2 <= 3000; ++radius2) {
    for_each_start(radius2, [&](Point from) {
      const Recurrence end = checked_walk(from, radius2);
      EXPECT_EQ(end.p, end_point(radius2)) << "radius2 " << radius2;
    });
    ASSERT_FALSE(HasFailure());
  }
}

// So F fits w + 2 bits with its sign where round(R) < 2^w.
TEST(CircularOracleEvaluationFunction, FStaysWithinTwiceTheRadius) {
  const auto check = [](Point from, std::uint64_t radius2) {
    const Recurrence end = checked_walk(from, radius2);
    const std::int64_t radius = nearest_root(radius2);
    ASSERT_GE(end.least, -2 * radius - 2) << "radius2 " << radius2;
    ASSERT_LE(end.greatest, 2 * radius + 1) << "radius2 " << radius2;
  };
  for (std::uint64_t r = 1; r <= 1023; ++r) {
    check({static_cast<std::int64_t>(r), 0}, r * r);
    ASSERT_FALSE(HasFailure());
  }
  for (std::uint64_t radius2 = 1; radius2 <= 1000; ++radius2) {
    for_each_start(radius2, [&](Point from) { check(from, radius2); });
    ASSERT_FALSE(HasFailure());
  }
}

TEST(CircularOracleRadialDeviation, OfEveryArcIsLessThanHalfAStep) {
  for (std::uint64_t r = 1; r <= 300; ++r) {
    Point p{static_cast<std::int64_t>(r), 0};
    while (p.x > 0) {
      p = next_point(p, r * r);
      const auto distance = std::hypot(static_cast<double>(p.x), static_cast<double>(p.y));
      ASSERT_LT(radial_deviation(p, r * r), 0.5);
      ASSERT_NEAR(radial_deviation(p, r * r), std::abs(distance - static_cast<double>(r)), 1e-11);
    }
  }
}

// sqrt(a^2 + d) = a + d / (2a) - d^2 / (8a^3) + ..., whose second term is far below 1e-9 here.
TEST(CircularOracleRadialDeviation, KeepsItsDigitsAtTheLargestRadius) {
  constexpr std::int64_t kRadius = 0xffff'ffff;
  constexpr auto kSquare =
      static_cast<std::uint64_t>(kRadius) * static_cast<std::uint64_t>(kRadius);
  EXPECT_EQ(radial_deviation({kRadius, 0}, kSquare), 0);
  EXPECT_NEAR(radial_deviation({kRadius, 1}, kSquare) * 2 * kRadius, 1, 1e-9);
  EXPECT_NEAR(radial_deviation({kRadius, 3}, kSquare) * 2 * kRadius, 9, 1e-9);
  EXPECT_NEAR(radial_deviation({kRadius, 0}, kSquare + kRadius), 0.5, 1e-9);
  EXPECT_NEAR(radial_deviation({0, 0}, kSquare), kRadius, 1e-6);
  EXPECT_EQ(radial_deviation({0, 0}, 0), 0);
  constexpr std::int64_t kMin = std::numeric_limits<std::int64_t>::min();
  EXPECT_DOUBLE_EQ(radial_deviation({kMin, kMin}, 0), std::ldexp(std::sqrt(2.0), 63));
}

// From one step inside to one outside; a start may be off the circle, and at the centre.
TEST(Deviation, IsKnownAboutAtOnce) {
  for (const std::uint64_t radius : {1ULL, 2ULL, 23ULL, 65'535ULL, 4'294'967'295ULL}) {
    const std::uint64_t radius2 = radius * radius;
    const auto step = static_cast<std::int64_t>(2 * radius);
    for (const std::int64_t excess : {-step, -step / 2, std::int64_t{-1}, std::int64_t{0},
                                      std::int64_t{1}, step / 3, step, 5 * step}) {
      if (excess < 0 && radius2 < static_cast<std::uint64_t>(-excess)) continue;
      const double exact = radial_deviation_by(excess, radius2);
      EXPECT_NEAR(about_radial_deviation_by(excess, radius2), exact, 1e-7 * exact)
          << radius << ' ' << excess;
    }
  }
}

}  // namespace
}  // namespace cosim::circular
