#include "model/toolpath/arc_pieces.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "model/circular/oracle.h"

namespace cosim::toolpath {
namespace {

using std::numbers::pi;

TEST(PointAfter, IsWhereWalkingLeads) {
  for (std::uint64_t radius2 = 1; radius2 <= 2500; ++radius2) {
    const circular::Point axis{circular::nearest_root(radius2), 0};
    for (Point from = axis; from.x > 0; from = circular::next_point(from, radius2)) {
      if (!circular::next_to_circle(from, radius2)) continue;
      Point walked = from;
      const std::int64_t count = circular::steps_to_end(from, radius2);
      for (std::int64_t i = 0; i <= count; ++i) {
        ASSERT_EQ(point_after(from, radius2, i), walked)
            << radius2 << " from " << from.x << ',' << from.y << " step " << i;
        walked = circular::next_point(walked, radius2);
      }
    }
  }
}

TEST(PointAfter, HoldsTheLargestCircle) {
  const std::int64_t radius = (std::int64_t{1} << 32) - 1;
  const auto radius2 = static_cast<std::uint64_t>(radius) * static_cast<std::uint64_t>(radius);
  const std::int64_t count = circular::steps_to_end({radius, 0}, radius2);
  EXPECT_EQ(point_after({radius, 0}, radius2, count), (Point{0, radius}));
  EXPECT_EQ(point_after({radius, 0}, radius2, 1), (Point{radius, 1}));
}

// The pieces of an arc about (0, 0) as "quadrant count", the quadrant being 1 to 4 in the plane.
std::string drawn(Point start, Point end, bool clockwise, double sweep) {
  std::string text;
  for (const Piece& piece : arc_pieces(1, {start, end, {0, 0}, clockwise, sweep}).pieces) {
    const Point inside = piece.orientation.to_plane({1, 1});
    const char* quadrants[] = {"3", "4", "2", "1"};
    text += quadrants[(inside.x > 0 ? 1 : 0) + (inside.y > 0 ? 2 : 0)];
    const auto& arc = std::get<circular::Arc>(piece.job);
    text += arc.count ? ":" + std::to_string(*arc.count) + " " : " ";
  }
  return text;
}

TEST(ArcPieces, CrossTheRightQuadrants) {
  EXPECT_EQ(drawn({5, 0}, {0, 5}, false, pi / 2), "1 ");
  EXPECT_EQ(drawn({5, 0}, {0, 5}, true, 3 * pi / 2), "4 3 2 ");
  EXPECT_EQ(drawn({5, 0}, {5, 0}, false, 2 * pi), "1 2 3 4 ");
  EXPECT_EQ(drawn({0, -5}, {0, -5}, true, 2 * pi), "3 2 1 4 ");
  EXPECT_EQ(drawn({4, 3}, {4, 3}, false, 2 * pi), "1 2 3 4 1:3 ");  // 3 rows up from (5, 0)
  EXPECT_EQ(drawn({4, 3}, {4, 3}, true, 2 * pi), "1 4 3 2 1:4 ");   // 4 columns from (0, 5)
  EXPECT_EQ(drawn({4, 3}, {3, 4}, false, 0.28), "1:1 ");
  EXPECT_EQ(drawn({3, 4}, {4, 3}, false, 6.0), "1 2 3 4 1:3 ");
  EXPECT_EQ(drawn({-4, -3}, {4, 3}, true, pi), "3 2 1:4 ");
}

TEST(ArcPieces, TheSweepDecidesWhatRoundingLeavesOpen) {
  EXPECT_EQ(drawn({5, 0}, {5, 0}, false, 0.05), "");             // fallen onto one point
  EXPECT_EQ(drawn({5, 0}, {5, -1}, false, 0.05), "");            // turned about by rounding
  EXPECT_EQ(drawn({5, 0}, {5, 0}, false, 6.2), "1 2 3 4 ");      // nearly full, rounded to full
  EXPECT_EQ(drawn({5, 0}, {5, 1}, false, 6.2), "1 2 3 4 1:1 ");  // nearly full, rounded past
  EXPECT_EQ(drawn({5, 0}, {5, 1}, false, 0.2), "1:1 ");
}

// Behind by the angle, though a row further up: nothing is drawn back and forth.
TEST(ArcPieces, AnEndBehindTheStartIsNotDrawn) {
  EXPECT_EQ(drawn({5, 2}, {8, 3}, false, 0.05), "");
}

// For (20, 0) to be the nearest point of its row, 19.5^2 < radius2 < 20.5^2: 381 to 420.
TEST(ArcPieces, TheCircleLiesBetweenTheEndsButNextToTheStart) {
  const auto radius2 = [](Point end) {
    return arc_pieces(1, {{20, 0}, end, {0, 0}, false, 1.5}).radius2;
  };
  EXPECT_EQ(radius2({0, 20}), 400u);
  EXPECT_EQ(radius2({5, 20}), 413u);  // (400 + 425) / 2
  EXPECT_EQ(radius2({0, 21}), 420u);  // not (400 + 441) / 2 = 420.5, rounded up
  EXPECT_EQ(radius2({0, 30}), 420u);
  EXPECT_EQ(radius2({7, 18}), 387u);  // (400 + 373) / 2
  EXPECT_EQ(radius2({0, 10}), 381u);
}

TEST(ArcPieces, NoneWhereAnEndIsTheCentre) {
  EXPECT_EQ(drawn({0, 0}, {1, 0}, false, 1), "");
  EXPECT_EQ(drawn({1, 0}, {0, 0}, false, 1), "");
}

TEST(ArcPieces, BeginNextToTheCircleAndChain) {
  std::mt19937_64 random(1);
  const auto coordinate = [&] { return static_cast<std::int64_t>(random() % 61) - 30; };
  for (int i = 0; i < 20000; ++i) {
    const GridArc arc{{coordinate(), coordinate()},
                      {coordinate(), coordinate()},
                      {coordinate(), coordinate()},
                      random() % 2 == 0,
                      static_cast<double>(random() % 6283 + 1) / 1000};
    const ArcPieces got = arc_pieces(1, arc);
    Point at{arc.start.x - arc.centre.x, arc.start.y - arc.centre.y};
    for (const Piece& piece : got.pieces) {
      const auto& job = std::get<circular::Arc>(piece.job);
      ASSERT_TRUE(circular::next_to_circle(job.from, job.radius2)) << i;
      ASSERT_EQ(piece.orientation.to_plane(job.from), at) << i;
      ASSERT_GE(steps(piece), 1) << i;
      at = piece.orientation.to_plane(point_after(job.from, job.radius2, steps(piece)));
    }
    ASSERT_EQ(got.reached, (Point{at.x + arc.centre.x, at.y + arc.centre.y})) << i;
  }
}

}  // namespace
}  // namespace cosim::toolpath
