// The cycle model of the DDA against closed forms, the source's flow chart and known accuracy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/designs/dda/flow_chart.h"
#include "tests/designs/dda/runs.h"
#include "tests/designs/dda/shapes.h"
#include "tests/support/model_adapter.h"
#include "tests/support/reachable.h"
#include "tests/support/sweeps.h"

namespace cosim::dda {
namespace {

template <int width>
const DdaBench& model() {
  return test::model_bench<Design, of_width(width)>();
}

// After n clocks each axis stands at the whole part of n times its rate, plus what it started with.
TEST(DdaModel, LinesAreWholePartsOfClocksTimesRates) {
  constexpr int kWidth = 6;
  for (std::int64_t dx = 0; dx < 64; dx += 3) {
    for (std::int64_t dy = 0; dy < 64; ++dy) {
      for (const Settings& settings : kEverySettings) {
        if (dx == 0 && dy == 0) continue;
        int shift = 0;
        while ((std::max(dx, dy) << shift) < 32) ++shift;
        const std::int64_t half = settings.preload == Preload::half ? 32 : 0;
        const auto drawn = points(model<kWidth>(), line(kWidth, {dx, dy}, settings));
        for (std::size_t clock = 0; clock < drawn.size(); ++clock) {
          const std::int64_t n = static_cast<std::int64_t>(clock) - shift;
          const auto along = [&](std::int64_t d) {
            return n < 0 ? 0 : std::min(d, (half + n * (d << shift)) / 64);
          };
          ASSERT_EQ(drawn[clock], (Point{along(dx), along(dy)})) << dx << ' ' << dy << ' ' << clock;
        }
        ASSERT_EQ(drawn.back(), (Point{dx, dy}));
        // 2^(W - s) clocks, and both axes end on the last of them.
        if (half == 0) {
          ASSERT_EQ(drawn.size(), static_cast<std::size_t>(shift + (64 >> shift) + 1));
          const Point last = drawn[drawn.size() - 2];
          ASSERT_EQ(last.x, std::max<std::int64_t>(dx - 1, 0));
          ASSERT_EQ(last.y, std::max<std::int64_t>(dy - 1, 0));
        }
      }
    }
  }
}

TEST(DdaModel, DrawsALineToEverySideAlike) {
  for (const Settings& settings : kEverySettings) {
    for (const Point to : {Point{27, 9}, Point{32, 31}, Point{5, 40}, Point{0, 12}}) {
      const auto first = points(model<6>(), line(6, to, settings));
      for (const Point side : {Point{-1, 1}, Point{1, -1}, Point{-1, -1}}) {
        auto other = points(model<6>(), line(6, {side.x * to.x, side.y * to.y}, settings));
        for (Point& p : other) p = {side.x * p.x, side.y * p.y};
        EXPECT_EQ(other, first) << to.x << ' ' << to.y;
      }
    }
  }
}

TEST(DdaModel, DrawsTheQuartersOfTheFlowChart) {
  for (std::int64_t radius = 1; radius < 256; ++radius) {
    for (const Settings& settings : kEverySettings) {
      ASSERT_EQ(points(model<8>(), arc(8, {radius, 0}, {0, radius}, settings)),
                flow_chart::quarter(8, radius, settings))
          << "R = " << radius;
    }
  }
}

// A rate is what the curve's equation says of the point, all the way round.
TEST(DdaModel, KeepsTheRatesOfAConicByAdditions) {
  const Conic q{2, 1, 3, -5, 4, -1428};  // 2 x^2 + xy + 3 y^2 - 5 x + 4 y = 1428
  for (const Settings& settings : kEverySettings) {
    const Job job = conic(8, q, {28, 0}, settings);
    std::size_t moved = 0;
    for (const auto& c : running(model<8>(), job)) {
      const auto number = [](Word code) { return from_twos_complement(code, 9); };
      const auto held = named<Held>(c.registers);
      const Word x = number(held.x), y = number(held.y);
      ASSERT_EQ(number(held.rate_x), -(q.b * x + 2 * q.c * y + q.e)) << x << ' ' << y;
      ASSERT_EQ(number(held.rate_y), 2 * q.a * x + q.b * y + q.d) << x << ' ' << y;
      moved += x < 0 && y < 0;
    }
    EXPECT_GT(moved, 20U);  // it did come to the other side
  }
}

TEST(DdaModelAgainstOracle, EveryLine) { test::expect_match(every_line(model<5>())); }
TEST(DdaModelAgainstOracle, EveryQuarter) { test::expect_match(every_quarter(model<8>())); }
TEST(DdaModelAgainstOracle, RandomJobs) {
  test::expect_match(random_jobs(model<2>(), 1, 2000));
  test::expect_match(random_jobs(model<10>(), 2, 2000));
  test::expect_match(random_jobs(model<32>(), 3, 2000));
}

// ---- Known accuracy -----------------------------------------------------------------------------

double off_circle(Point at, std::int64_t radius) {
  return std::fabs(std::hypot(static_cast<double>(at.x), static_cast<double>(at.y)) -
                   static_cast<double>(radius));
}

double worst_of(const Job& job, const DdaBench& bench, std::int64_t radius) {
  double worst = 0;
  for (const Point& at : points(bench, job)) worst = std::max(worst, off_circle(at, radius));
  return worst;
}

TEST(DdaAccuracy, OfALineIsBelowAStep) {
  const Result lines = test::expect_match(every_line(model<6>()));
  EXPECT_LT(lines.checked.number("max_deviation"), 1);
  EXPECT_GT(lines.checked.number("max_deviation"), 0.95);
}

TEST(DdaAccuracy, OfAQuarterWithHalfPreloadIsAboutOne) {
  double worst = 0;
  for (std::int64_t r = 1; r < 1024; r += 7) {
    const Job job = arc(10, {r, 0}, {0, r}, {Update::parallel, Preload::half, false});
    worst = std::max(worst, worst_of(job, model<10>(), r));
  }
  EXPECT_GT(worst, 1.1);
  EXPECT_LT(worst, 1.3);
}

// A full turn at 10 bits: about 1.5 sequentially. In parallel each clock goes along the tangent, so
// the radius grows by half of R / 2^20 of itself 2 pi 2^10 times, pi in all for R near 2^10; the
// error of a quarter comes on top.
TEST(DdaAccuracy, OfAFullTurnDrifts) {
  const auto turn = [](std::int64_t radius, Update update) {
    return worst_of(circle(10, radius, {update, Preload::zero, false}), model<10>(), radius);
  };
  EXPECT_GT(turn(1000, Update::parallel), std::numbers::pi * 1000 / 1024 + 0.7);
  EXPECT_LT(turn(1000, Update::parallel), std::numbers::pi * 1000 / 1024 + 1.3);
  EXPECT_NEAR(turn(1000, Update::sequential), 1.5, 0.2);
}

// Every number of the state comes back from its code.
void expect_recovered(const Params& p, const State<Word>& s) {
  const auto fields = State<Word>::fields(p);
  const auto numbers = to_words(s), codes = to_words(Design::registers(p, s));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const Field& f = fields[i];
    const bool is_signed = f.format == Format::twos_complement;
    ASSERT_EQ(codes[i], low_bits(codes[i], f.width)) << f.name;
    ASSERT_EQ(is_signed ? from_twos_complement(codes[i], f.width) : codes[i], numbers[i]) << f.name;
  }
}

TEST(DdaReachable, StatesFitTheRegisters) {
  test::expect_states_fit_the_registers<Design>(expect_recovered);
}

}  // namespace
}  // namespace cosim::dda
