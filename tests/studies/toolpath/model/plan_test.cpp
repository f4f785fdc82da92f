#include "model/toolpath/plan.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/studies/toolpath/model/helpers.h"

namespace cosim::toolpath {
namespace {

TEST(Quantise, RoundsHalvesAwayFromZero) {
  EXPECT_EQ(quantise({0.5, -0.5}, 1, 10), (Point{1, -1}));
  EXPECT_EQ(quantise({1.25, -1.24}, 10, 100), (Point{13, -12}));
  // Halves of what was written in decimals, most of which no double is.
  EXPECT_EQ(quantise({4.475, 4.485}, 100, 1000), (Point{448, 449}));
  EXPECT_EQ(quantise({0.145, -0.155}, 100, 1000), (Point{15, -16}));
  EXPECT_EQ(quantise({1.005, -1.015}, 100, 1000), (Point{101, -102}));
  EXPECT_EQ(quantise({5, -15}, 0.3, 1000), (Point{2, -5}));
  EXPECT_EQ(quantise({1000.004999999, 20000000.005}, 100, max_coordinate),
            (Point{100000, 2000000001}));
  EXPECT_EQ(quantise({10.49, 0}, 1, 10), (Point{10, 0}));
  EXPECT_EQ(quantise({10.5, 0}, 1, 10), std::nullopt);
  EXPECT_EQ(quantise({0, std::nan("")}, 1, 10), std::nullopt);
}

TEST(Plan, TargetsAreQuantisedAbsolutely) {
  std::string text = "G91 G1\n";
  for (int i = 0; i < 1000; ++i) text += "X0.3 Y0.4\n";
  const Plan p = plan(read(text), 1);
  ASSERT_EQ(p.segments.size(), 1000u);
  for (int i = 1; i <= 1000; ++i) {
    const Point end = p.segments[static_cast<std::size_t>(i - 1)].end;
    EXPECT_EQ(end, (Point{(3 * i + 5) / 10, (4 * i + 5) / 10})) << i;
  }
}

// Each target and centre is a grid point, though hardly one of these products is exact in doubles.
TEST(Plan, WhatLiesOnTheGridHasNoQuantisationError) {
  const Program p = read(
      "G0 X10.1 Y3.3\nG1 X20.7 Y8.9\nG3 X20.7 Y18.9 J5\nG2 X30.7 Y28.9 R10\n"
      "G1 X-1234.7 Y.1\nG2 I.7\n");
  for (const double scale : {10.0, 100.0, 1e4, 1e5}) {
    EXPECT_EQ(plan(p, scale).largest_quantisation, 0) << scale;
  }
  EXPECT_EQ(plan(read("G0 X10 Y20\nG3 X0 Y30 I-10"), 80.7).largest_quantisation, 0);
  // Far out, what the program says is still seen.
  EXPECT_GT(plan(read("G0 X1.000000003"), 1e8).largest_quantisation, 0.29);
}

TEST(Plan, SubStepMotionsCountAndNeedNoPiece) {
  const Plan p = plan(read("G0 X5\nX5.2\nX5.4\nX6"), 1);
  ASSERT_EQ(p.segments.size(), 4u);
  EXPECT_EQ(p.segments[1].pieces, 0u);
  EXPECT_EQ(p.segments[2].pieces, 0u);
  ASSERT_EQ(p.pieces.size(), 2u);
  EXPECT_EQ(p.pieces[1].segment, 4u);
}

TEST(Plan, StatesTheQuantisationOfALineByItsFurtherEnd) {
  const Plan p = plan(read("G0 X5.4\nX7.1\nX8.3"), 1);
  EXPECT_NEAR(p.segments[0].quantisation, 0.4, 1e-9);
  EXPECT_NEAR(p.segments[1].quantisation, 0.4, 1e-9);
  EXPECT_NEAR(p.segments[2].quantisation, 0.3, 1e-9);
  EXPECT_NEAR(p.largest_quantisation, 0.4, 1e-9);
}

TEST(Plan, ScalesByStepsPerMm) {
  const Plan p = plan(read("G1 X10.004 Y-2"), 200);
  EXPECT_EQ(p.segments[0].end, (Point{2001, -400}));
  EXPECT_EQ(p.longest_line, 2001);
  EXPECT_EQ(p.arc_width, 0);
  EXPECT_NEAR(p.largest_quantisation, 0.2, 1e-9);  // 2000.8 to 2001
}

TEST(Plan, OfAnArcOnTheGridIsExact) {
  const Plan p = plan(read("G0 X-5\nG2 X0 Y5 I5\n"), 10);
  const Segment& arc = p.segments[1];
  EXPECT_EQ(arc.centre, (Point{0, 0}));
  EXPECT_EQ(arc.radius2, 2500u);
  EXPECT_EQ(arc.closing, 0);
  EXPECT_EQ(arc.quantisation, 0);
  EXPECT_EQ(p.arc_width, 6);  // 50 steps
  EXPECT_EQ(p.longest_line, 50);
  ASSERT_EQ(p.pieces.size(), 2u);
  EXPECT_FALSE(std::get<circular::Arc>(p.pieces[1].job).count);
}

// From (20, 0) about (0, 0) to (0, 21) on the grid: the circle next to the start has the squared
// radius 420, meets the axis at 20, and a line of one step closes it.
TEST(Plan, ClosesAnArcThatMissesItsEnd) {
  const Plan p = plan(read("G0 X.02\nG3 X0 Y.021 I-.02"), 1000);
  EXPECT_EQ(p.segments[1].radius2, 420u);
  EXPECT_EQ(p.segments[1].closing, 1);
  EXPECT_EQ(p.largest_closing, 1);
  ASSERT_EQ(p.pieces.size(), 3u);
  EXPECT_EQ(std::get<LineJob>(p.pieces[2].job).major, 1);
  EXPECT_EQ(p.pieces[2].segment, 2u);
  EXPECT_NEAR(p.segments[1].quantisation, 21 - std::sqrt(420), 1e-9);
}

// Centre (0.4, 0) falls to (0, 0); the ends (10.4, 0) and (0.4, 10) to (10, 0) and (0, 10).
TEST(Plan, StatesTheQuantisationOfAnArcOffTheGrid) {
  const Plan p = plan(read("G0 X10.4\nG3 X.4 Y10 I-10\n"), 1);
  EXPECT_EQ(p.segments[1].radius2, 100u);
  EXPECT_NEAR(p.segments[1].quantisation, 0.4, 1e-9);
  EXPECT_EQ(p.segments[1].closing, 0);
}

TEST(Plan, ACircleOfLessThanHalfAStepIsAPoint) {
  const Plan p = plan(read("G3 I.2\nG0 X9"), 1);
  EXPECT_EQ(p.segments[0].pieces, 0u);
  EXPECT_EQ(p.segments[0].radius2, 0u);
  EXPECT_NEAR(p.segments[0].quantisation, 0.4, 1e-9);  // the circle's far side
}

TEST(Plan, RefusesWhatIsOutOfReach) {
  const auto error = [](std::string_view text, double scale) {
    return error_of([&] { plan(read(text), scale); });
  };
  const std::string target = "the target is beyond the reach of 2147483647 steps";
  const std::string radius = "the arc's radius is beyond the reach of 4294967295 steps";
  EXPECT_EQ(error("G0 X2147483.647", 1000), "");
  EXPECT_EQ(error("G0 Y1\n  X2147483.648", 1000), "p.ngc:2:3: " + target);
  EXPECT_EQ(error("G0 Y-2147483.648", 1000), "p.ngc:1:4: " + target);
  EXPECT_EQ(error("G3 X1 R4294967.294", 1000), "");
  EXPECT_EQ(error("G3 X1 R4294967.297", 1000), "p.ngc:1:4: " + radius);
  EXPECT_EQ(error("G3 X1 R900000000", 1e9), "p.ngc:1:4: " + radius);
  EXPECT_EQ(error("G0 X1", 1e300), "p.ngc:1:4: " + target);
  const std::string scale = "the number of steps per mm must be finite and above 0";
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(error("G0 X1", bad), scale);
  }
}

}  // namespace
}  // namespace cosim::toolpath
