// Arcs: the points of the CSV against the midpoint test on the circle itself.
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "tests/cli/drawing.h"
#include "tests/cli/help.h"
#include "tests/designs/circular/cli/circle.h"

namespace cosim::cli {
namespace {

constexpr int kWidths[] = {4, 8, 12, 16, 24, 32};

std::string point(Lattice p) { return std::to_string(p.x) + "," + std::to_string(p.y); }

// The rows that a walk along the circle gives; the sector change takes a clock of its own unless
// the arc ends or starts behind it.
void expect_arc(const Drawing& d, Lattice from, std::uint64_t radius2, std::int64_t most) {
  Lattice at = from;
  bool sector2 = at.y >= at.x;
  std::int64_t clock = 0, made = 0;
  double deviation = radial_deviation(at, radius2);
  for (const StepRow& row : d.steps("clock")) {
    ASSERT_LT(made, most);
    ASSERT_GT(at.x, 0) << "a step past the end";
    const Lattice next = next_on_circle(at, radius2);
    ++clock;
    ASSERT_EQ(row, (StepRow{clock, next.x - at.x, next.y - at.y, next.x, next.y}))
        << "after " << point(at);
    at = next;
    ++made;
    deviation = std::max(deviation, radial_deviation(at, radius2));
    if (!sector2 && at.y >= at.x) {
      sector2 = true;
      ++clock;
    }
  }
  if (made < most) {
    EXPECT_EQ(at.x, 0) << "the arc is not over at " << point(at);
    EXPECT_EQ(at.y, rounded_root(radius2));
  }
  EXPECT_EQ(d.report["steps"], made);
  EXPECT_NEAR(d.report["max_deviation"].get<double>(), deviation, 1e-8);
  EXPECT_LT(deviation, 0.5);
}

TEST(Arc, OfTheSourceGivesItsTable) {
  const Drawing d = draw({"arc", "--radius", "12"});
  std::vector<std::string> expected{"clock,dx,dy,x,y"};
  Lattice at{12, 0};
  int clock = 0;
  for (const char step : std::string("|||/|/|//=/-/-/---")) {  // Table 1; = is the correction
    ++clock;
    const int dx = step == '|' || step == '=' ? 0 : -1;
    const int dy = step == '-' || step == '=' ? 0 : 1;
    at = {at.x + dx, at.y + dy};
    if (step == '=') continue;
    expected.push_back(std::to_string(clock) + "," + std::to_string(dx) + "," + std::to_string(dy) +
                       "," + point(at));
  }
  EXPECT_EQ(d.csv, expected);
  EXPECT_EQ(d.csv.back(), "18,-1,0,0,12");
  EXPECT_EQ(d.report["parameters"], (nlohmann::json{{"W", 4}}));
  expect_arc(d, {12, 0}, 144, 1000);
}

TEST(Arc, OfEverySmallRadiusIsTheNearest) {
  for (std::uint64_t r = 0; r <= 15; ++r) {
    SCOPED_TRACE(r);
    expect_arc(draw({"arc", "--radius", std::to_string(r)}), {static_cast<std::int64_t>(r), 0},
               r * r, 1000);
  }
}

// Radii that are not whole, from anywhere, stopped or not, on every machine.
TEST(Arc, FromAnywhereIsTheNearest) {
  std::mt19937_64 random(3);
  for (const int width : kWidths) {
    for (int i = 0; i < 16; ++i) {
      const std::uint64_t largest = (std::uint64_t{1} << width) - 1;
      const std::uint64_t r = 1 + random() % largest;
      const std::uint64_t radius2 = i % 4 == 0 ? r * r : r * r - r + 1 + random() % (2 * r - 1);
      const std::int64_t along = static_cast<std::int64_t>(random() % (r * 7 / 10 + 1));
      const std::int64_t across = across_from(along, radius2);
      if (across <= along) continue;
      const Lattice from = i % 2 == 0 ? Lattice{across, along} : Lattice{along, across};
      const bool stopped = r > 1000 || i % 3 == 0;
      const std::int64_t most = stopped ? static_cast<std::int64_t>(random() % 2000) : 1 << 20;
      SCOPED_TRACE("R^2 = " + std::to_string(radius2) + " from " + point(from) +
                   " W=" + std::to_string(width));
      Arguments command{"arc", "--radius2", std::to_string(radius2), "--from", point(from)};
      command.insert(command.end(), {"--width", std::to_string(width)});
      if (stopped) command.insert(command.end(), {"--count", std::to_string(most)});
      const Drawing d = draw(command);
      EXPECT_EQ(d.report["parameters"], (nlohmann::json{{"W", width}}));
      expect_arc(d, from, radius2, most);
      if (HasFatalFailure()) return;
    }
  }
}

TEST(Arc, StartsOnTheAxisByDefault) {
  for (const std::uint64_t radius2 : {2U, 3U, 12U, 13U, 150U, 23U * 23U, 1000003U}) {
    SCOPED_TRACE(radius2);
    expect_arc(draw({"arc", "--radius2", std::to_string(radius2)}), {rounded_root(radius2), 0},
               radius2, 1 << 20);
  }
}

TEST(Arc, StopsAfterTheCount) {
  for (int count = 0; count <= 20; ++count) {
    SCOPED_TRACE(count);
    const Drawing d = draw({"arc", "--radius", "12", "--count", std::to_string(count)});
    EXPECT_EQ(d.report["steps"], std::min(count, 17));
    expect_arc(d, {12, 0}, 144, count);
  }
}

TEST(Arc, OfRadius0IsAPoint) {
  for (const char* radius : {"--radius", "--radius2"}) {
    const Drawing d = draw({"arc", radius, "0"});
    EXPECT_EQ(d.csv.size(), 1U);
    EXPECT_EQ(d.report["steps"], 0);
    EXPECT_EQ(d.report["max_deviation"], 0.0);
  }
}

TEST(Arc, RunsOnTheSmallestMachineThatHoldsIt) {
  const auto machine = [](const char* name, const std::string& value, const Arguments& more = {}) {
    const std::string text = cosim(joined({"arc", name, value, "--count", "3"}, more)).out;
    return text.substr(0, text.find(':'));
  };
  EXPECT_EQ(machine("--radius", "15"), "circular W=4");
  EXPECT_EQ(machine("--radius", "16"), "circular W=8");
  EXPECT_EQ(machine("--radius2", "240"), "circular W=4");  // 15.49 starts at 15,
  EXPECT_EQ(machine("--radius2", "241"), "circular W=8");  // 15.52 at 16
  EXPECT_EQ(machine("--radius", "256"), "circular W=12");
  EXPECT_EQ(machine("--radius", "4096"), "circular W=16");
  EXPECT_EQ(machine("--radius", "65536"), "circular W=24");
  EXPECT_EQ(machine("--radius", "16777216"), "circular W=32");
  EXPECT_EQ(machine("--radius", "4294967295"), "circular W=32");
  EXPECT_EQ(machine("--radius", "12", {"--width", "24"}), "circular W=24");
}

TEST(Arc, HasAHelpThatNamesEveryOption) {
  expect_in(help({"arc"}), {"--from X,Y", "--radius R", "--radius2 Q", "--count K", "--width W",
                            "--csv FILE", "clock,dx,dy,x,y", "--report FILE", "--seed S"});
}

}  // namespace
}  // namespace cosim::cli
