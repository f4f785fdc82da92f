// What is written for a curve, and what is refused.
#include "model/dda/curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "model/dda/equation.h"
#include "model/dda/oracle.h"
#include "tests/designs/dda/records.h"
#include "tests/support/error_of.h"

namespace cosim::dda {
namespace {

using Clocks = std::optional<std::int64_t>;

constexpr int kW = 8;

TEST(DdaCurve, DeviationIsKnownAboutAtOnce) {
  constexpr int width = 16;
  for (const Job& job :
       {line(width, {27, -9}, {}), line(width, {-65'535, 1}, {}), arc(width, {12, 0}, {0, 12}, {}),
        arc(width, {52'428, 39'321}, {39'321, 52'428}, {}), circle(width, 1, {}, 9)}) {
    for (const std::int64_t twice : {-100'000, -77, -1, 0, 1, 8, 100'000}) {
      const double exact = deviation_by(job, twice);
      if (!(exact >= 0)) continue;  // so far inside there is no circle
      if (twice == 0) EXPECT_EQ(about_deviation_by(job, twice), 0);
      EXPECT_NEAR(about_deviation_by(job, twice), exact, 1e-7 * exact) << twice;
    }
  }
}

TEST(DdaCurve, OfALine) {
  const Job job = line(kW, {27, -9}, {});
  EXPECT_EQ(job.start, (Start{false, true, false, 0, 255, 27, -9, 0, 0, 27, 9}));
  EXPECT_FALSE(job.clocks);
}

// Half of 2^8 forwards, and its ones' complement for X, which goes back.
TEST(DdaCurve, OfAQuarter) {
  const Job job = arc(kW, {12, 0}, {0, 12}, {Update::sequential, Preload::half, true});
  EXPECT_EQ(job.start, (Start{true, false, false, 127, 128, 0, 12, 12, 0, 12, 12, 1, 0, 1}));
}

// As many steps as lie between its ends.
TEST(DdaCurve, OfAnArcInside) {
  const Job job = arc(kW, {80, 60}, {60, 80}, {});
  EXPECT_EQ(job.start, (Start{false, false, false, 255, 0, -60, 80, 80, 60, 20, 20, 1, 0, 1}));
}

TEST(DdaCurve, OfAnEllipseIsOneTurn) {
  const Job job = conic(kW, {1, 0, 4, 0, 0, -400}, {20, 0}, {});
  EXPECT_EQ(job.start.two_a, 2);
  EXPECT_EQ(job.start.two_c, 8);
  EXPECT_EQ(job.start.rate_x, 0);
  EXPECT_EQ(job.start.rate_y, 40);
  EXPECT_TRUE(job.start.free);
  EXPECT_EQ(job.clocks, 402);  // 2 pi 256 / sqrt(16) = 402.1
  Track track(kW, job);
  while (track.next()) continue;
  EXPECT_LT(deviation(job, track.at()), 3);
  EXPECT_NEAR(static_cast<double>(track.at().x), 20, 3);
}

TEST(DdaCurve, IsOffByItsEquation) {
  const Job job = arc(kW, {100, 0}, {0, 100}, {});
  EXPECT_EQ(deviation(job, {100, 0}), 0);
  EXPECT_EQ(deviation(job, {60, 80}), 0);
  EXPECT_NEAR(deviation(job, {103, 0}), 3, 1e-12);
  EXPECT_NEAR(deviation(job, {0, 0}), 100, 1e-12);
  // The same circle about (10, -20).
  const Job moved = conic(kW, {-1, 0, -1, 20, -40, 9500}, {110, -20}, {});
  EXPECT_NEAR(deviation(moved, {10, 70}), 10, 1e-12);
  // Of x^2 + 4 y^2 = 400 at (0, 11): 84 / 88.
  EXPECT_NEAR(deviation(conic(kW, {1, 0, 4, 0, 0, -400}, {20, 0}, {}), {0, 11}), 84 / 88.0, 1e-12);
  EXPECT_EQ(deviation(line(kW, {10, 5}, {}), {4, 3}), 1);
}

// Where the gradient is small or nothing the equation over it says nothing of the distance.
TEST(DdaCurve, IsOffByTheDistanceFromItsMiddleToo) {
  const Job ellipse = conic(kW, {1, 0, 4, 0, 0, -400}, {20, 0}, {});
  EXPECT_NEAR(deviation(ellipse, {0, 0}), 10, 1e-12);
  EXPECT_NEAR(deviation(ellipse, {0, 1}), 9, 1e-12);
  EXPECT_NEAR(deviation(ellipse, {0, -3}), 7, 1e-12);
  // From (3, 0) the nearest point is at x = 3 / (1 - 1/4) = 4.
  EXPECT_NEAR(deviation(ellipse, {3, 0}), std::hypot(1, std::sqrt(96)), 1e-12);
  // Of x^2 - x y + y^2 = 1 the shorter half axis is sqrt(2/3).
  EXPECT_NEAR(deviation(conic(kW, {1, -1, 1, 0, 0, -1}, {1, 0}, {}), {0, 0}), std::sqrt(2 / 3.0),
              1e-12);
  // The vertices of x^2 - y^2 = 400, whose centre is no nearer to anything else.
  const Job hyperbola = conic(kW, {1, 0, -1, 0, 0, -400}, {20, 0}, {}, 1);
  EXPECT_NEAR(deviation(hyperbola, {0, 0}), 20, 1e-12);
  EXPECT_NEAR(deviation(hyperbola, {0, 4}), std::hypot(std::sqrt(404), 2), 1e-12);
  // y = x^2 from its axis, where the foot lies at y - 1/2.
  const Job parabola = conic(kW, {1, 0, 0, 0, -1, 0}, {0, 0}, {}, 1);
  EXPECT_NEAR(deviation(parabola, {0, 5}), std::hypot(std::sqrt(4.5), 0.5), 1e-12);
}

// As registers may stand that no curve asked for: the value is that of two lines, or of a point.
TEST(DdaCurve, IsOffByAFiniteDistanceWhateverItIs) {
  for (const Word a : {-2, 0, 1}) {
    for (const Word b : {-1, 0, 2}) {
      for (const Word c : {-3, 0, 2}) {
        for (const Word rate : {-1, 0, 1}) {
          Job job;
          job.start.two_a = a;
          job.start.b = b;
          job.start.two_c = c;
          job.start.rate_x = rate;
          for (std::int64_t x = -3; x <= 3; ++x) {
            for (std::int64_t y = -3; y <= 3; ++y) {
              const double off = deviation(job, {x, y});
              EXPECT_TRUE(off >= 0 && off <= std::hypot(x, y) + 1e-9) << off;
              const auto [on_x, on_y] = on_curve(job, {x, y});
              EXPECT_TRUE(std::isfinite(on_x) && std::isfinite(on_y));
            }
          }
        }
      }
    }
  }
}

// Against all ways that go out from a point, a thousand of them.
TEST(DdaCurve, IsOffByTheShortestWay) {
  for (const Conic q :
       {Conic{1, -1, 1, 0, 0, -100}, {3, 1, 1, 4, -30, -340}, {2, -7, 1, 3, 5, -230}}) {
    const Job job = conic(kW, q, {10, 0}, {}, 1);
    for (std::int64_t x = -12; x <= 12; ++x) {
      for (std::int64_t y = -12; y <= 12; ++y) {
        const auto px = static_cast<double>(x), py = static_cast<double>(y);
        const auto a = static_cast<double>(q.a), b = static_cast<double>(q.b),
                   c = static_cast<double>(q.c), d = static_cast<double>(q.d),
                   e = static_cast<double>(q.e), f = static_cast<double>(q.f);
        const double value = a * px * px + b * px * py + c * py * py + d * px + e * py + f;
        double least = 1e9;
        for (int i = 0; i < 1000; ++i) {
          const double u = std::cos(i * 0.0062831853), v = std::sin(i * 0.0062831853);
          const double slope = (2 * a * px + b * py + d) * u + (b * px + 2 * c * py + e) * v;
          const double bend = a * u * u + b * u * v + c * v * v;
          const double root2 = slope * slope - 4 * bend * value;
          if (root2 < 0) continue;
          for (const double sign : {-1, 1}) {
            const double way = 2 * value / (-slope + sign * std::sqrt(root2));
            if (way >= 0) least = std::min(least, way);
          }
        }
        EXPECT_NEAR(deviation(job, {x, y}), least, least / 8 + 1e-3) << x << ' ' << y;
      }
    }
  }
}

TEST(DdaCurve, HasAPointNextToAnyOther) {
  const auto expect_on = [](const Job& job, Point at, double x, double y) {
    const auto [on_x, on_y] = on_curve(job, at);
    EXPECT_NEAR(on_x, x, 1e-9) << at.x << ' ' << at.y;
    EXPECT_NEAR(on_y, y, 1e-9) << at.x << ' ' << at.y;
  };
  const Job quarter = arc(kW, {100, 0}, {0, 100}, {});
  expect_on(quarter, {60, 80}, 60, 80);
  expect_on(quarter, {103, 0}, 100, 0);
  const auto [x, y] = on_curve(quarter, {0, 0});  // from the centre each point is as near
  EXPECT_NEAR(std::hypot(x, y), 100, 1e-9);
  expect_on(conic(kW, {-1, 0, -1, 20, -40, 9500}, {110, -20}, {}), {10, 70}, 10, 80);
  expect_on(conic(kW, {1, 0, 4, 0, 0, -400}, {20, 0}, {}), {0, 11}, 0, 10);
  expect_on(line(kW, {10, 5}, {}), {4, 3}, 4.4, 2.2);
}

TEST(DdaCurve, IsRefusedInOneLine) {
  const Settings settings;
  const auto of = [](const std::string& says, const std::function<void()>& curve) {
    EXPECT_EQ(test::error_of(curve).substr(0, says.size()), says);
  };
  const auto of_line = [&](const std::string& says, Point to) {
    of(says, [&] { line(kW, to, settings); });
  };
  const auto of_arc = [&](const std::string& says, Point from, Point to) {
    of(says, [&] { arc(kW, from, to, settings); });
  };
  const auto of_circle = [&](const std::string& says, std::int64_t radius, Clocks clocks = {}) {
    of(says, [&] { circle(kW, radius, settings, clocks); });
  };
  const auto of_conic = [&](const std::string& says, const Conic& q, Point from, Clocks clocks = {},
                            int width = kW) {
    of(says, [&] { conic(width, q, from, settings, clocks); });
  };
  of_line("line: DX = 256 does not fit dda W=8", {256, 0});
  of_line("line: DY = -256 does not fit dda W=8", {0, -256});
  of_arc("arc: (0, 12) to (12, 0) does not go left and up", {0, 12}, {12, 0});
  of_arc("arc: (0, 13) is off the circle of (12, 0)", {12, 0}, {0, 13});
  of_circle("circle: R = 0 is no radius", 0);
  of_circle("circle: its rates overflow dda W=8 at ", 255);
  of_circle("circle: -1 clocks are not", 12, -1);
  of_conic("conic: 2 A = 256 does not fit", {128, 0, 1, 0, 0, -4}, {2, 0});
  // Products that 64 bits do not hold.
  of_conic("conic: A = -4611686018427387904 is more than 2147483647 in size",
           {-(std::int64_t{1} << 62), 0, 1, 0, 0, -4}, {2, 0});
  constexpr int wide = 32;
  of_conic("conic: F = 144115188075855873 is more than 144115188075855872 in size",
           {1, 0, 1, 0, 0, (std::int64_t{1} << 57) + 1}, {0, 0}, {}, wide);
  of_conic("conic: it does not pass (4294967295, 0)", {0x7fffffff, 0, 1, 0, 0, -1}, {0xffffffff, 0},
           {}, wide);
  of_conic("conic: its rates overflow every machine at (4294967295, 2)",
           {1, -0x7fffffff, 0, -1, 0, 2}, {0xffffffff, 2}, {}, wide);
  of_conic("conic: it is degenerate", {1, 0, -1, 0, 0, 0}, {2, 2});
  of_conic("conic: it is degenerate", {0, 0, 0, 1, -1, 0}, {2, 2});
  of_conic("conic: it is degenerate", {0, 1, 0, -1, -1, 1}, {1, 5}, 10);  // (x - 1) (y - 1) = 0
  of_conic("conic: it does not pass (11, 0)", {1, 0, 1, 0, 0, -109}, {11, 0});
  of_conic("conic: it does not pass (5, 0)", {1, 0, 1, 0, 0, -9}, {5, 0});
  of_conic("conic: (0, 0) is its centre", {1, 0, 1, 0, 0, -9}, {0, 0});
  of_conic("conic: it is no ellipse", {1, 0, 0, 0, -4, 0}, {0, 0});
  of_conic("conic: its rates overflow dda W=8 at ", {1, 0, 4, 0, 0, -10000}, {100, 0});
  // Parabolas, which rise to y = x^2 / 4 = 256, and the other to x = 256.
  of_conic("conic: it leaves the codes of dda W=8 at (32, 256)", {1, 0, 0, 0, -4, 0}, {0, 0}, 4000);
  of_conic("conic: it leaves the codes of dda W=8 at (256, -3", {0, 0, 1, -4, 0, 0}, {0, 0}, 4000);
  of_conic("conic: 268435456 clocks are not", {1, 0, 1, 0, 0, -9}, {3, 0}, 1 << 28);
}

// ---- The host -----------------------------------------------------------------------------------

TEST(DdaHost, WritesTheModesThenEveryRegister) {
  const std::vector<Job> jobs{line(kW, {27, -9}, {Update::sequential, Preload::zero, true})};
  HostOf<Design> host(of_width(kW), jobs);
  Inputs<Word> in;
  const Word data[] = {3, 0, 255, 27, 512 - 9, 0, 0, 27, 9, 0, 0, 0};
  for (Word address = 0; address < 12; ++address) {
    ASSERT_TRUE(host.next(in, {}));
    EXPECT_EQ(to_words(in), (Words<Inputs<Word>>{0, 1, address, data[address], address == 11, 0}));
  }
  ASSERT_TRUE(host.next(in, {}));
  EXPECT_EQ(to_words(in), to_words(rest_of<Design>()));
  EXPECT_FALSE(host.next(in, {}));  // not busy: over
}

TEST(DdaHost, HasNothingToDoWithoutJobs) {
  HostOf<Design> host(of_width(kW), {});
  Inputs<Word> in;
  EXPECT_FALSE(host.next(in, {}));
}

TEST(DdaHost, TriesSmallerJobs) {
  for (const Job& job : smaller(line(kW, {27, 9}, {}))) {
    EXPECT_LT(job.start.left_x + job.start.left_y, 36);
    EXPECT_NE(describe(job), "");
  }
  const auto arcs = smaller(arc(kW, {12, 0}, {0, 12}, {}));
  ASSERT_EQ(arcs.size(), 2U);
  EXPECT_EQ(arcs[0].clocks, 512);
  EXPECT_EQ(arcs[1].clocks, 1023);
  Job none = arcs[0];
  none.clocks = 0;
  EXPECT_TRUE(smaller(none).empty());
}

}  // namespace
}  // namespace cosim::dda
