// The errata of SU 1665343 that change what the machine draws. For each: what the source as printed
// would draw, on RTL changed to it; that lockstep finds it; and that the RTL as shipped does not.
//
// Arcs start at (R, 0). They are loaded and started on clock 0 and take a step a clock from clock 1
// on; in sector 1 each of them is one in Y.
#include <gtest/gtest.h>

#include "model/circular/oracle.h"
#include "tests/designs/circular/records.h"
#include "tests/rtl/straight.h"
#include "tests/support/point.h"

namespace cosim::circular {
namespace {

using test::expect_found, test::expect_same;
using Script = test::Script<Design>;
using Variant = test::Variant<Design>;
using Points = std::vector<Point>;

const Variant& shipped(int width) {
  return test::variant<Design>("shipped/w" + std::to_string(width));
}
const Variant& printed(const std::string& name) { return test::variant<Design>("errata/" + name); }

std::uint64_t square(std::int64_t radius) { return static_cast<std::uint64_t>(radius * radius); }

Pins load(int width, std::int64_t radius) {
  const Setup s = setup({radius, 0}, square(radius));
  return {.load = 1,
          .f = low_bits(s.f, width + 2),
          .ct7 = to_ones_complement(s.ct7, width + 1),
          .ct8 = to_ones_complement(s.ct8, width + 1)};
}

/// The arc, and `clocks` clocks after its start.
Script arc(int width, std::int64_t radius, std::int64_t clocks) {
  Pins start = load(width, radius);
  start.start = 1;
  Script script = {record_of<Inputs<Word>>(start)};
  script.resize(static_cast<std::size_t>(clocks) + 1, rest_of<Design>());
  return script;
}
/// To its end: no arc has more than 2R steps.
Script arc(int width, std::int64_t radius) { return arc(width, radius, 2 * radius + 3); }

/// The start and the point after each step.
Points drawn(const Variant& variant, const Script& script, std::int64_t radius) {
  Points points = {{radius, 0}};
  for (const auto& clock : test::play(variant, script)) {
    const Point step = step_of(clock.outputs);
    if (step == Point{}) continue;
    points.push_back({points.back().x + step.x, points.back().y + step.y});
  }
  return points;
}

Points exact(std::int64_t radius) {
  Points points = {{radius, 0}};
  while (points.back().x > 0) points.push_back(next_point(points.back(), square(radius)));
  return points;
}

/// The first point of sector 2.
Point change(std::int64_t radius) {
  for (const Point& p : exact(radius)) {
    if (p.x <= p.y) return p;
  }
  return {};
}
bool to_the_diagonal(std::int64_t radius) { return change(radius).x == change(radius).y; }

// As wired the change at CT8 = -1 is not seen, and past 45 degrees sector 1's rule finds the circle
// inside each time: the path goes on straight, along the tangent.
TEST(CircularW16Errata, C4AsPrintedLeavesTheCircleAtTheDiagonal) {
  for (std::int64_t radius = 2; radius <= 100; ++radius) {
    if (!to_the_diagonal(radius)) continue;
    const std::int64_t side = change(radius).x;
    Points tangent = exact(radius);
    tangent.resize(static_cast<std::size_t>(side) + 1);
    for (std::int64_t k = 1; k <= side; ++k) tangent.push_back({side - k, side + k});
    EXPECT_EQ(drawn(printed("c4"), arc(16, radius, 2 * side), radius), tangent) << "R = " << radius;
  }
}

TEST(CircularW16Errata, C4AsPrintedIsSixStepsOffAtRadius14) {
  ASSERT_EQ(change(14), (Point{10, 10}));
  const Points points = drawn(printed("c4"), arc(16, 14, 20), 14);
  EXPECT_EQ(points.back(), (Point{0, 20}));
  EXPECT_EQ(radial_deviation(points.back(), square(14)), 6.0);
}

TEST(CircularW16Errata, C4AsPrintedDrawsTheOthers) {
  for (std::int64_t radius = 2; radius <= 100; ++radius) {
    if (to_the_diagonal(radius)) continue;
    EXPECT_EQ(drawn(printed("c4"), arc(16, radius), radius), exact(radius)) << "R = " << radius;
  }
}

TEST(CircularW16Errata, C4IsFoundByLockstep) {
  expect_found(printed("c4"), arc(16, 14), {1 + 10, "step_y", 0, 1});
}

TEST(CircularW16Errata, C4AsShippedDrawsBothChanges) {
  for (std::int64_t radius = 1; radius <= 100; ++radius) {
    EXPECT_EQ(drawn(shipped(16), arc(16, radius), radius), exact(radius)) << "R = " << radius;
    expect_same(shipped(16), arc(16, radius));
  }
}

/// C5 as printed, in numbers: the source's recurrences from (R, 0), where a diagonal step to
/// X = Y adds 2(X - Y) - 1 = -1 to F or, as channel 1 gives it, -0.
struct Recurrence {
  Point p;
  std::int64_t f = 0;  // floor(F): the fraction is always .75
  bool sector2 = false;

  void step(bool minus_one) {
    const bool diagonal = sector2 == (f >= 0);
    if (sector2 || diagonal) --p.x;
    if (!sector2 || diagonal) ++p.y;
    const bool reached = !sector2 && p.x == p.y;
    if (!diagonal) {
      f += sector2 ? 2 * p.x - 1 : -(2 * p.y + 1);
    } else if (!reached || minus_one) {
      f += 2 * (p.x - p.y) - 1;
    }
    if (!sector2 && p.x <= p.y) {
      sector2 = true;
      f += p.x + p.y;
    }
  }
};

Points stepped(std::int64_t radius, bool minus_one) {
  Recurrence r{{radius, 0}, radius - 2};  // F(R, 0) = R - 1.25
  Points points = {r.p};
  while (r.p.x > 0) {
    r.step(minus_one);
    points.push_back(r.p);
  }
  return points;
}

TEST(CircularErrata, C5ChangesThePathOf1370RadiiFrom14On) {
  std::vector<std::int64_t> changed;
  for (std::int64_t radius = 1; radius <= 4096; ++radius) {
    Recurrence r{{radius, 0}, radius - 2};
    Point nearest = r.p;
    while (nearest.x > 0 && nearest == r.p) {
      r.step(false);
      nearest = next_point(nearest, square(radius));
    }
    if (nearest != r.p) changed.push_back(radius);
  }
  EXPECT_EQ(changed.size(), 1370u);
  EXPECT_EQ(changed.front(), 14);
}

TEST(CircularErrata, C5WithTheMinusOneChangesNone) {
  for (std::int64_t radius = 1; radius <= 300; ++radius) {
    EXPECT_EQ(stepped(radius, true), exact(radius)) << "R = " << radius;
  }
}

TEST(CircularW4Errata, C5AsPrintedDrawsTheChangedPath) {
  for (std::int64_t radius = 1; radius < 16; ++radius) {
    const Points points = drawn(printed("c5"), arc(4, radius), radius);
    EXPECT_EQ(points, stepped(radius, false)) << "R = " << radius;
    EXPECT_EQ(points == exact(radius), radius != 14) << "R = " << radius;
  }
}

// The step to (10, 10) is the tenth; F shows it on the next clock. In quarters the codes of 4
// apart.
TEST(CircularW4Errata, C5IsFoundByLockstep) {
  Recurrence r{{14, 0}, 14 - 2};
  for (int step = 0; step < 9; ++step) r.step(true);
  ASSERT_EQ(r.p, (Point{11, 9}));
  ASSERT_LT(r.f, 0);  // a diagonal step is next
  const auto code = [](std::int64_t f) { return to_ones_complement(shift_left(f, 2) + 3, 4 + 4); };
  expect_found(printed("c5"), arc(4, 14), {1 + 10, "f", code(r.f - 1), code(r.f)});
}

TEST(CircularW4Errata, C5AsShippedDrawsEveryRadius) {
  for (std::int64_t radius = 1; radius < 16; ++radius) {
    EXPECT_EQ(drawn(shipped(4), arc(4, radius), radius), exact(radius)) << "R = " << radius;
    expect_same(shipped(4), arc(4, radius));
  }
}

/// R = 12, the arc of the source's tables, with a request on the clock of its fifth step, which
/// takes F to -2.25 and CT7 to 5 at (11, 5).
Script disturbed(const Pins& request) {
  Script script = arc(4, 12, 40);
  script[5] = record_of<Inputs<Word>>(request);
  return script;
}

Pins level34() { return {.sector2 = 1}; }

// After five steps the whole of the other arc is drawn, from where the first one stands.
TEST(CircularW4Errata, C10AsPrintedTakesALoadWhileRunning) {
  const Points points = drawn(printed("c10_load"), disturbed(load(4, 5)), 12);
  EXPECT_EQ(points.size(), 1 + 5 + (exact(5).size() - 1));
  EXPECT_EQ(points.back(), (Point{11 - 5, 5 + 5}));
}

// CT7 holds Y where sector 2 has X - 1, so that X + 1 = 6 steps in X are left and not 11.
TEST(CircularW4Errata, C10AsPrintedChangesSectorWhileRunning) {
  const Points points = drawn(printed("c10_sector2"), disturbed(level34()), 12);
  EXPECT_EQ(points[5], (Point{11, 5}));
  EXPECT_EQ(points.size(), 1 + 5 + 6u);
  EXPECT_EQ(points.back().x, 11 - 6);
}

// -2.25 is -9 quarters, in the eight bits of F 255 - 9; the other arc's 5 - 1.25 is 15 quarters.
TEST(CircularW4Errata, C10IsFoundByLockstep) {
  expect_found(printed("c10_load"), disturbed(load(4, 5)), {6, "f", 255 - 9, 15});
  expect_found(printed("c10_sector2"), disturbed(level34()), {6, "t16", 0, 1});
}

TEST(CircularW4Errata, C10AsShippedLetsNoRequestDisturbAnArc) {
  const Pins start{.start = 1};
  Pins all = load(4, 5);
  all.start = all.sector2 = 1;
  const auto steps = static_cast<std::int64_t>(exact(12).size()) - 1;
  for (const Pins& request : {load(4, 5), level34(), start, all}) {
    Script script = arc(4, 12, 40);
    // Running from clock 1: the steps, the correction and the end.
    for (std::int64_t c = 1; c <= steps + 2; ++c)
      script[static_cast<std::size_t>(c)] = record_of<Inputs<Word>>(request);
    EXPECT_EQ(drawn(shipped(4), script, 12), exact(12));
    expect_same(shipped(4), script);
  }
}

}  // namespace
}  // namespace cosim::circular
