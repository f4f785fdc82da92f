// Whole paths, from text to steps, against the exact curves.
#include "model/toolpath/walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/studies/toolpath/model/helpers.h"

namespace cosim::toolpath {
namespace {

using std::numbers::pi;

TEST(Walk, GivesTheStepsOfALine) {
  // Major 4 with weights 2, 1, 1: two minor steps are the first bit, positions 1 and 3.
  const Plan p = plan(read("G1 X-2 Y4"), 1);
  std::vector<Step> path;
  const Point end = walk(p, 3, linear::greedy_code, [&](const Step& s) { path.push_back(s); });
  EXPECT_EQ(end, (Point{-2, 4}));
  const std::vector<Step> expected = {
      {1, -1, 1, {-1, 1}}, {1, 0, 1, {-1, 2}}, {1, -1, 1, {-2, 3}}, {1, 0, 1, {-2, 4}}};
  EXPECT_EQ(path, expected);
}

TEST(Walk, GivesTheStepsOfAnArc) {
  // Clockwise from (-2, 0) about (0, 0) to the top, then a line: the points nearest to R = 2.
  const Plan p = plan(read("G0 X-2\nG2 X0 Y2 I2\nG1 X1"), 1);
  const std::vector<Step> expected = {{1, -1, 0, {-1, 0}}, {1, -1, 0, {-2, 0}}, {2, 0, 1, {-2, 1}},
                                      {2, 1, 1, {-1, 2}},  {2, 1, 0, {0, 2}},   {3, 1, 0, {1, 2}}};
  EXPECT_EQ(walked(p), expected);
}

// The twice signed area of a closed path, positive anticlockwise.
double area2(const std::vector<Step>& path) {
  double sum = 0;
  for (const Step& s : path)
    sum += static_cast<double>((s.at.x - s.dx) * s.dy - (s.at.y - s.dy) * s.dx);
  return sum;
}

TEST(Walk, FullCirclesFromEveryQuadrantReturnAndGoRound) {
  for (const int centre_x : {-30, -18, 0, 18, 30}) {
    const int centre_y = 30 * 30 - centre_x * centre_x == 576 ? 24 : centre_x == 0 ? 30 : 0;
    for (const int side : {-1, 1}) {
      for (const char* code : {"G2", "G3"}) {
        const std::string text = std::string(code) + " I" + std::to_string(centre_x) + " J" +
                                 std::to_string(side * centre_y);
        const Plan p = plan(read(text), 1);
        const std::vector<Step> path = walked(p);
        EXPECT_EQ(flaw(p, path), "") << text;
        EXPECT_EQ(path.back().at, (Point{0, 0})) << text;
        EXPECT_EQ(p.segments[0].closing, 0) << text;
        const auto [left, right] = std::minmax_element(
            path.begin(), path.end(), [](auto& a, auto& b) { return a.at.x < b.at.x; });
        const auto [low, high] = std::minmax_element(
            path.begin(), path.end(), [](auto& a, auto& b) { return a.at.y < b.at.y; });
        EXPECT_EQ(left->at.x, centre_x - 30) << text;
        EXPECT_EQ(right->at.x, centre_x + 30) << text;
        EXPECT_EQ(low->at.y, side * centre_y - 30) << text;
        EXPECT_EQ(high->at.y, side * centre_y + 30) << text;
        const double sense = code[1] == '3' ? 1 : -1;
        EXPECT_NEAR(area2(path), sense * 2 * pi * 900, 2 * 2 * pi * 30 * 0.5) << text;
      }
    }
  }
}

// A random arc off the grid, as a program of a line to its start and the arc.
struct RandomArcs {
  std::mt19937_64 random{20240607};

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  }

  Program next(double smallest, double largest) {
    Motion line;
    line.end = {uniform(-60, 60), uniform(-60, 60)};
    Motion arc;
    arc.kind = random() % 2 == 0 ? MotionKind::arc_cw : MotionKind::arc_ccw;
    arc.start = line.end;
    const double radius = smallest * std::pow(largest / smallest, uniform(0, 1));
    const double angle = uniform(0, 2 * pi);
    // A third each of any sweep, nearly nothing and nearly a full turn, where rounding decides.
    const double little = std::min(uniform(1e-9, 2 / radius), 2 * pi);
    const double sweeps[] = {uniform(1e-9, 2 * pi), little, 2 * pi - 0.999 * little};
    arc.sweep = sweeps[random() % 3];
    const double last = angle + (arc.kind == MotionKind::arc_ccw ? arc.sweep : -arc.sweep);
    arc.centre = {arc.start.x - radius * std::cos(angle), arc.start.y - radius * std::sin(angle)};
    arc.end = {arc.centre.x + radius * std::cos(last), arc.centre.y + radius * std::sin(last)};
    Program program;
    program.motions = {line, arc};
    return program;
  }
};

// The bounds that docs/interpolators/toolpaths.md may name. Quantising moves centre and start by up
// to 0.71 each, the circle then misses start by up to half a step along an axis, and the machine
// adds half a step.
TEST(Walk, RandomArcsStayOnTheCircleAndEndOnTheTarget) {
  RandomArcs arcs;
  double furthest = 0;
  std::int64_t closing = 0;
  for (int i = 0; i < 100000; ++i) {
    const Program program = arcs.next(0.2, 200);
    const Motion& exact = program.motions[1];
    const double radius =
        std::hypot(exact.start.x - exact.centre.x, exact.start.y - exact.centre.y);
    const Plan p = plan(program, 1);
    const std::vector<Step> path = walked(p);
    ASSERT_EQ(flaw(p, path), "") << i;
    const Segment& segment = p.segments[1];
    closing = std::max(closing, segment.closing);
    if (segment.radius2 == 0) continue;
    for (const Step& s : path) {
      if (s.segment == 1) continue;
      const double x = static_cast<double>(s.at.x) - exact.centre.x;
      const double y = static_cast<double>(s.at.y) - exact.centre.y;
      const double off = std::abs(std::hypot(x, y) - radius);
      furthest = std::max(furthest, off);
      const bool closes = std::max(std::abs(s.at.x - segment.end.x),
                                   std::abs(s.at.y - segment.end.y)) < segment.closing;
      if (closes) continue;
      ASSERT_LE(off, segment.quantisation + 0.5 + 1e-9) << i;
    }
  }
  EXPECT_LE(furthest, 2.5);
  EXPECT_LE(closing, 3);
}

TEST(Walk, RandomArcsTurnByTheirSweep) {
  RandomArcs arcs;
  for (int i = 0; i < 30000; ++i) {
    const Program program = arcs.next(6, 300);
    const Motion& exact = program.motions[1];
    const double radius =
        std::hypot(exact.start.x - exact.centre.x, exact.start.y - exact.centre.y);
    const Plan p = plan(program, 1);
    double turned = 0;
    for (const Step& s : walked(p)) {
      if (s.segment == 1) continue;
      const double x = static_cast<double>(s.at.x) - exact.centre.x;
      const double y = static_cast<double>(s.at.y) - exact.centre.y;
      turned += std::atan2((x - s.dx) * s.dy - (y - s.dy) * s.dx, x * (x - s.dx) + y * (y - s.dy));
    }
    const double sense = exact.kind == MotionKind::arc_ccw ? 1 : -1;
    // Each end is off by at most sqrt(1/2) step.
    ASSERT_NEAR(sense * turned, exact.sweep, 2 * std::asin(std::sqrt(0.5) / radius)) << i;
  }
}

TEST(Walk, RandomProgramsAreConnectedAtEveryScale) {
  std::mt19937_64 random(3);
  const auto number = [&] {
    return std::to_string(static_cast<double>(random() % 40001) / 1000 - 20);
  };
  for (int i = 0; i < 300; ++i) {
    std::string text = "G0 X1 Y1\n";
    for (int line = 0; line < 30; ++line) {
      switch (random() % 4) {
        case 0:
          text += "G0 X" + number() + "\n";
          break;
        case 1:
          text += "G1 X" + number() + " Y" + number() + "\n";
          break;
        case 2:
          text += "G3 I" + number() + " J" + number() + "\n";
          break;
        default:
          text += "G2 X" + number() + " Y" + number() + " R-60\n";
      }
    }
    const Plan p = plan(read(text), static_cast<double>(random() % 1000 + 1) / 100);
    ASSERT_EQ(flaw(p, walked(p)), "") << text;
  }
}

}  // namespace
}  // namespace cosim::toolpath
