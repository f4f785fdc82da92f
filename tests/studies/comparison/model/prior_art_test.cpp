// The prior art against brute force: products, roots and searches where the models add.
#include <gtest/gtest.h>

#include <cmath>

#include "model/prior_art/bresenham.h"
#include "model/prior_art/midpoint_circle.h"
#include "model/prior_art/rate_multiplier.h"
#include "model/prior_art/single_axis_circle.h"
#include "model/prior_art/su875343.h"

namespace cosim::prior_art {
namespace {

// Position q of n = 1 .. 2^m sees the bit of weight 2^m / 2^i on every (2^i)-th position from
// 2^(i-1) on.
TEST(RateMultiplier, GivesEachBitEvenly) {
  for (int m = 1; m <= 7; ++m) {
    const std::int64_t all = std::int64_t{1} << m;
    for (Line line{0, 0}; line.major < all; ++line.major) {
      line.minor = line.major * 3 / 7;
      const Points points = rate_multiplier(m, line);
      ASSERT_EQ(points.size(), static_cast<std::size_t>(all + 1));
      ASSERT_EQ(points.back(), (Point{line.major, line.minor}));
      for (std::int64_t q = 1; q <= all; ++q) {
        const auto count = [&](std::int64_t length) {
          std::int64_t steps = 0;
          for (int i = 1; i <= m; ++i) {
            const std::int64_t period = std::int64_t{1} << i;
            if ((length >> (m - i)) % 2 == 1) steps += (q + period / 2) / period;
          }
          return steps;
        };
        ASSERT_EQ(points[static_cast<std::size_t>(q)],
                  (Point{count(line.major), count(line.minor)}))
            << "m = " << m << ", BP = " << line.major << ", q = " << q;
      }
    }
  }
}

TEST(Bresenham, IsNearestOnEachPosition) {
  for (std::int64_t major = 1; major <= 100; ++major) {
    for (std::int64_t minor = 0; minor <= major; ++minor) {
      const Points points = bresenham({major, minor});
      ASSERT_EQ(points.size(), static_cast<std::size_t>(major + 1));
      for (std::int64_t q = 0; q <= major; ++q) {
        const Point& at = points[static_cast<std::size_t>(q)];
        ASSERT_EQ(at.x, q);
        // Half a step at most; halfway between two the lower one.
        ASSERT_LT(2 * (at.y * major - q * minor), major);
        ASSERT_GE(2 * (at.y * major - q * minor), -major);
      }
      ASSERT_EQ(points.back(), (Point{major, minor}));
    }
  }
}

// The row's or the column's lattice point whose square is nearest to the circle's by distance.
std::int64_t nearest(std::int64_t line, double radius2) {
  const double exact = std::sqrt(std::max(0.0, radius2 - static_cast<double>(line * line)));
  return std::llround(exact);
}

Arc quarter(std::int64_t radius) {
  return {{radius, 0}, static_cast<std::uint64_t>(radius * radius), {0, radius}};
}

TEST(MidpointCircle, IsNearestOnEveryRowThenColumn) {
  for (std::int64_t radius = 1; radius <= 400; ++radius) {
    const Points points = midpoint_circle(quarter(radius));
    const auto radius2 = static_cast<double>(radius * radius);
    EXPECT_EQ(points.front(), (Point{radius, 0}));
    EXPECT_EQ(points.back(), (Point{0, radius}));
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& p = points[i];
      if (p.x > p.y) ASSERT_EQ(p.x, nearest(p.y, radius2)) << radius;
      if (p.y > p.x) ASSERT_EQ(p.y, nearest(p.x, radius2)) << radius;
      if (i == 0) continue;
      const Point& q = points[i - 1];
      ASSERT_TRUE(p.x <= q.x && p.y >= q.y && q.x - p.x <= 1 && p.y - q.y <= 1) << radius;
      ASSERT_FALSE(p == q) << radius;
    }
  }
}

TEST(MidpointCircle, DrawsAPart) {
  const Points whole = midpoint_circle(quarter(100));
  for (std::size_t from = 0; from < whole.size(); from += 13) {
    for (std::size_t to = from; to < whole.size(); to += 17) {
      EXPECT_EQ(midpoint_circle({whole[from], 10000, whole[to]}),
                Points(whole.begin() + static_cast<std::ptrdiff_t>(from),
                       whole.begin() + static_cast<std::ptrdiff_t>(to) + 1));
    }
  }
}

TEST(SingleAxisCircle, StepsTowardsTheCircleOnOneAxis) {
  for (std::int64_t radius = 1; radius <= 200; ++radius) {
    const Points points = single_axis_circle(quarter(radius));
    ASSERT_EQ(points.size(), static_cast<std::size_t>(2 * radius + 1));
    ASSERT_EQ(points.back(), (Point{0, radius}));
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Point& q = points[i - 1];
      const bool inside = q.x * q.x + q.y * q.y < radius * radius;
      if (q.y < radius && q.x > 0) {
        ASSERT_EQ(points[i], inside ? (Point{q.x, q.y + 1}) : (Point{q.x - 1, q.y})) << radius;
      }
    }
  }
}

// From every point, to every one behind it.
void expect_parts(const Points& whole, Points (*draw)(const Arc&), std::uint64_t radius2) {
  for (std::size_t from = 0; from < whole.size(); ++from) {
    for (std::size_t to = from; to < whole.size(); ++to) {
      ASSERT_EQ(draw({whole[from], radius2, whole[to]}),
                Points(whole.begin() + static_cast<std::ptrdiff_t>(from),
                       whole.begin() + static_cast<std::ptrdiff_t>(to) + 1))
          << from << " to " << to;
    }
  }
}

TEST(SingleAxisCircle, DrawsAPart) {
  expect_parts(single_axis_circle(quarter(50)), single_axis_circle, 2500);
}

// From (7, 7), inside, it would go up.
TEST(SingleAxisCircle, StaysInTheRowOfAnEndBesideItsWay) {
  const Points points = single_axis_circle({{10, 0}, 100, {6, 7}});
  ASSERT_EQ(points.size(), 12U);
  EXPECT_EQ(points[10], (Point{7, 7}));
  EXPECT_EQ(points[11], (Point{6, 7}));
}

TEST(Su875343, DrawsAPartBefore45Degrees) {
  Points octant = su875343(quarter(50));
  std::erase_if(octant, [](const Point& p) { return p.x <= p.y; });
  EXPECT_EQ(octant.size(), 36U);  // rows 0 to 35: 50 / sqrt(2) = 35.4
  expect_parts(octant, su875343, 2500);
}

TEST(Su875343, IsNearestTo45DegreesAndThenTheTangent) {
  for (std::int64_t radius = 2; radius <= 400; ++radius) {
    const Points points = su875343(quarter(radius));
    bool tangent = false;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Point &q = points[i - 1], &p = points[i];
      if (q.x > q.y && !tangent) {
        ASSERT_EQ(p.x, std::max(nearest(p.y, static_cast<double>(radius * radius)), q.x - 1))
            << radius << " row " << p.y;
      }
      const bool diagonal = p.x == q.x - 1 && p.y == q.y + 1;
      if (q.x <= q.y && diagonal) tangent = true;
      if (tangent) ASSERT_TRUE(diagonal) << radius;
    }
    EXPECT_TRUE(tangent);
    EXPECT_EQ(points.back().x, 0);
    // Twice the R / sqrt(2) of 45 degrees, where the circle has R.
    EXPECT_NEAR(static_cast<double>(points.back().y), std::sqrt(2) * static_cast<double>(radius),
                1.5);
  }
}

}  // namespace
}  // namespace cosim::prior_art
