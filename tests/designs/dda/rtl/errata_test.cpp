// The errata of the DDA's source that change what is drawn. For each: what the source as printed
// would draw, on RTL changed to it; that lockstep finds it; and that the RTL as shipped does not.
//
// The host writes on clocks 0 to 11 and starts on the last of them: the machine runs from clock 12.
#include <gtest/gtest.h>

#include <cmath>

#include "model/dda/equation.h"
#include "tests/designs/dda/flow_chart.h"
#include "tests/designs/dda/records.h"
#include "tests/rtl/straight.h"
#include "tests/support/point.h"

namespace cosim::dda {
namespace {

using test::expect_found, test::expect_same;
using Script = test::Script<Design>;
using Variant = test::Variant<Design>;
using Points = std::vector<Point>;

constexpr int kWidth = 6;
constexpr std::int64_t kSize = 64;  // of an accumulator
constexpr Word kCodes = 128;        // of a rate
constexpr std::uint64_t kFirstClock = 12;
constexpr Settings kSettings{};  // parallel, from 0

const Variant& printed(const std::string& name) { return test::variant<Design>("errata/" + name); }
const Variant& shipped() { return test::variant<Design>("shipped/w6"); }

/// What the host gives the machine for a job.
Script script_of(const Job& job) {
  HostOf<Design> host(of_width(kWidth), {&job, 1});
  Script script;
  Inputs<Word> in;
  Outputs<Word> seen{};
  State<Word> state;
  while (host.next(in, seen)) {
    script.push_back(in);
    const auto step = Design::next(of_width(kWidth), state, in);
    seen = step.outputs;
    state = step.state;
  }
  return script;
}

/// The start, and the point after each clock.
Points drawn(const Variant& variant, const Job& job) {
  Points points;
  for (const auto& clock : test::play(variant, script_of(job))) {
    const auto shown = named<Shown>(clock.outputs);
    if (shown.busy == 0) continue;
    points.push_back({from_twos_complement(shown.code_x, kWidth + 1),
                      from_twos_complement(shown.code_y, kWidth + 1)});
  }
  return points;
}

/// The same by the formulas: `rates` of a point go into both accumulators on each clock, and no
/// axis is ever done.
template <class Rates>
Points told(const Job& job, std::int64_t clocks, Rates rates) {
  std::int64_t sum_x = job.start.sx, sum_y = job.start.sy;
  const auto step = [](std::int64_t& sum, std::int64_t rate) {
    EXPECT_LT(std::abs(rate), kSize);
    sum += rate;
    const std::int64_t whole = sum >= kSize ? 1 : sum < 0 ? -1 : 0;
    sum -= whole * kSize;
    return whole;
  };
  Points points{{job.start.x, job.start.y}};
  for (std::int64_t clock = 0; clock < clocks; ++clock) {
    const Point at = points.back(), rate = rates(at);
    const std::int64_t dx = step(sum_x, rate.x), dy = step(sum_y, rate.y);
    points.push_back({at.x + dx, at.y + dy});
  }
  return points;
}

Point circle_rates(Point p) { return {-p.y, p.x}; }

double largest_deviation(const Job& job, const Points& points) {
  double largest = 0;
  for (const Point& p : points) largest = std::max(largest, deviation(job, p));
  return largest;
}

// ---- D1: the minus sign -------------------------------------------------------------------------

constexpr std::int64_t kHalfRadian = kSize / 2;

Job part_of_circle(std::int64_t radius) { return circle(kWidth, radius, kSettings, kHalfRadian); }

// x' = y and y' = x leave x^2 - y^2 as it is: (R, 0) goes along a hyperbola to (R cosh t, R sinh
// t).
TEST(DdaW6Errata, D1AsPrintedDrawsAHyperbola) {
  for (std::int64_t radius = 10; radius <= 40; ++radius) {
    const Points points = drawn(printed("d1"), part_of_circle(radius));
    EXPECT_EQ(points, told(part_of_circle(radius), kHalfRadian, [](Point p) {
                return Point{p.y, p.x};
              }));
    EXPECT_NEAR(static_cast<double>(points.back().x), std::cosh(0.5) * double(radius), 2);
    EXPECT_NEAR(static_cast<double>(points.back().y), std::sinh(0.5) * double(radius), 2);
    EXPECT_GT(largest_deviation(part_of_circle(radius), points), 0.24 * double(radius) - 2);
  }
}

// From 0 the accumulator of Y has its first carry on the sixth clock, 6 * 12 >= 64 > 5 * 12; the
// rate of X turns by 2C = 1.
TEST(DdaW6Errata, D1IsFoundByLockstep) {
  expect_found(printed("d1"), script_of(part_of_circle(12)),
               {kFirstClock + 6, "rate_x", kCodes - 1, 1});
}

TEST(DdaW6Errata, D1AsShippedDrawsTheCircle) {
  for (std::int64_t radius = 10; radius <= 40; ++radius) {
    const Job job = part_of_circle(radius);
    EXPECT_EQ(drawn(shipped(), job), told(job, kHalfRadian, circle_rates));
    EXPECT_LT(largest_deviation(job, drawn(shipped(), job)), 2);
    expect_same(shipped(), script_of(job));
  }
}

// ---- D2: Bx, not By -----------------------------------------------------------------------------

constexpr Conic kTilted{1, 1, 1, 0, 0, -100};  // x^2 + xy + y^2 = 100
constexpr std::int64_t kTurn = 232;            // 2 pi 64 / sqrt(4 - 1)

Job tilted(std::int64_t clocks) { return conic(kWidth, kTilted, {10, 0}, kSettings, clocks); }
/// The same started with the rate that the printed text gives for (10, 0).
Job tilted_as_printed(std::int64_t clocks) {
  Job job = tilted(clocks);
  job.start.rate_x = 0;
  return job;
}

// With x' = -3y and y' = 2x + y the divergence is 1, where it is 0 for a closed curve: a spiral.
TEST(DdaW6Errata, D2AsPrintedLeavesTheConic) {
  constexpr std::int64_t kClocks = 100;
  const Points points = drawn(printed("d2"), tilted_as_printed(kClocks));
  EXPECT_EQ(points, told(tilted_as_printed(kClocks), kClocks, [](Point p) {
              return Point{-3 * p.y, 2 * p.x + p.y};
            }));
  EXPECT_GT(largest_deviation(tilted(kClocks), points), 5);
}

// From 0 the accumulator of Y has its first carry on the fourth clock, 4 * 20 >= 64 > 3 * 20,
// before that of X at a rate of -10. The rate of X turns by -2C or, as printed, by -(B + 2C).
TEST(DdaW6Errata, D2IsFoundByLockstep) {
  expect_found(printed("d2"), script_of(tilted(kTurn)),
               {kFirstClock + 4, "rate_x", kCodes - 12, kCodes - 13});
}

TEST(DdaW6Errata, D2AsShippedDrawsTheConic) {
  const Points points = drawn(shipped(), tilted(kTurn));
  EXPECT_EQ(points, told(tilted(kTurn), kTurn, [](Point p) {
              return Point{-(p.x + 2 * p.y), 2 * p.x + p.y};
            }));
  EXPECT_LT(largest_deviation(tilted(kTurn), points), 3);
  expect_same(shipped(), script_of(tilted(kTurn)));
}

// ---- D3: the hardware and the flow chart --------------------------------------------------------

Job quarter(std::int64_t radius, Update update = Update::parallel) {
  return arc(kWidth, {radius, 0}, {0, radius}, {update, Preload::zero, true});
}

// The last point is that of the clock that stops.
TEST(DdaW6Errata, D3AsShippedDrawsBothAsTheyAreTold) {
  int different = 0;
  for (std::int64_t radius = 1; radius < kSize; ++radius) {
    for (const Update update : {Update::parallel, Update::sequential}) {
      const Settings settings{update, Preload::zero, true};
      EXPECT_EQ(drawn(shipped(), quarter(radius, update)),
                flow_chart::quarter(kWidth, radius, settings))
          << "R = " << radius;
      expect_same(shipped(), script_of(quarter(radius, update)));
    }
    different += drawn(shipped(), quarter(radius, Update::parallel)) !=
                 drawn(shipped(), quarter(radius, Update::sequential));
  }
  EXPECT_GT(different, 50);
}

// ---- D4: an axis that is done -------------------------------------------------------------------

// From 0 both accumulators of a quarter are late, and at its end that of X is later: Y has to wait.
TEST(DdaW6Errata, D4AsPrintedOverruns) {
  int overrun = 0;
  for (std::int64_t radius = 1; radius < kSize; ++radius) {
    const auto highest = [&](const Variant& variant) {
      std::int64_t most = 0;
      for (const Point& p : drawn(variant, quarter(radius))) most = std::max(most, p.y);
      return most;
    };
    overrun += highest(printed("d4")) > radius;
    EXPECT_EQ(highest(shipped()), radius);
  }
  EXPECT_GT(overrun, 10);
}

// The clock of the step that takes Y past its end.
TEST(DdaW6Errata, D4IsFoundByLockstep) {
  const Points points = told(quarter(12), 2 * kSize, circle_rates);
  std::uint64_t steps = 0;
  while (points[steps].y <= 12) ++steps;
  ASSERT_GT(points[steps].x, 0);
  expect_found(printed("d4"), script_of(quarter(12)), {kFirstClock + steps - 1, "y_up", 0, 1});
}

TEST(DdaW6Errata, D4AsShippedStopsEachAxis) {
  for (std::int64_t radius = 1; radius < kSize; ++radius) {
    EXPECT_EQ(drawn(shipped(), quarter(radius)).back(), (Point{0, radius}));
    expect_same(shipped(), script_of(quarter(radius)));
  }
}

}  // namespace
}  // namespace cosim::dda
