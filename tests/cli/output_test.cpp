// What the program writes for other programs, against the sources and a plain calculation.
#include <cmath>
#include <nlohmann/json.hpp>

#include "tb/support/random.h"
#include "tests/cli/command.h"

namespace cosim::test {
namespace {

using nlohmann::json;
using Output = Command;

TEST_F(Output, TheLineOfTheSourceHasTheWordsOfItsTable3) {
  ASSERT_EQ(run("line --major 27 --minor 9 --code 01010 --csv l.csv").status, 0);
  EXPECT_EQ(slurp(file("l.csv")),
            "tick,major,minor\n1,11111111,01000101\n2,11111111,01000100\n"
            "3,11111111,01000101\n4,11100000,01000000\n");
}

TEST_F(Output, TheArcOfTheSourceHasTheStepsOfItsTable2) {
  ASSERT_EQ(run("arc --radius 12 --csv a.csv").status, 0);
  std::string steps;
  for (const auto& row : rows(slurp(file("a.csv")))) {
    if (row[0] == "clock") continue;
    steps += row[1] == "0" ? '|' : row[2] == "0" ? '-' : '/';
  }
  EXPECT_EQ(steps, "|||/|/|///-/-/---");
}

TEST_F(Output, EmptyWorkMatches) {
  EXPECT_EQ(run("line --major 0 --minor 0").status, 0);
  EXPECT_EQ(run("arc --radius 0").status, 0);
  EXPECT_EQ(run("arc --radius 9 --count 0").status, 0);
}

// Bit i of the code, from the left, is the minor step of the positions 2^(i-1) * odd.
TEST_F(Output, RandomLinesAreTheBinaryRateOfTheirCode) {
  Random random(7);
  for (int i = 0; i < 40; ++i) {
    const auto major = static_cast<std::int64_t>(random.below(70'000)) + 1;
    const auto minor =
        static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(major) + 1));
    const Said said = run("line --major " + std::to_string(major) + " --minor " +
                          std::to_string(minor) + " --csv l.csv --report r.json");
    ASSERT_EQ(said.status, 0) << said.err;
    const json report = json::parse(slurp(file("r.json")));
    std::string majors, minors;
    for (const auto& row : rows(slurp(file("l.csv")))) {
      if (row[0] == "tick") continue;
      majors += row[1];
      minors += row[2];
    }
    ASSERT_EQ(majors.substr(0, static_cast<std::size_t>(major)),
              std::string(static_cast<std::size_t>(major), '1'));
    ASSERT_EQ(majors.find('1', static_cast<std::size_t>(major)), std::string::npos);
    std::int64_t count = 0;
    double worst = 0;
    std::vector<int> rate(64, -1);  // of each power of two
    for (std::int64_t q = 1; q <= major; ++q) {
      const int step = minors[static_cast<std::size_t>(q - 1)] - '0';
      int& due = rate[static_cast<std::size_t>(__builtin_ctzll(static_cast<std::uint64_t>(q)))];
      if (due < 0) due = step;
      ASSERT_EQ(step, due) << "position " << q;
      count += step;
      worst = std::max(worst, std::abs(static_cast<double>(count) -
                                       static_cast<double>(q) * static_cast<double>(minor) /
                                           static_cast<double>(major)));
    }
    ASSERT_EQ(count, minor);
    EXPECT_NEAR(report["max_deviation"].get<double>(), worst, 1e-9);
    EXPECT_EQ(report["verdict"], "match");
    EXPECT_EQ(report["design"], "linear");
    EXPECT_EQ(report["steps"], major);
    EXPECT_EQ(report["compared_signals"].size(), 13U);
    EXPECT_EQ(report["seed"], 1);
    EXPECT_GT(report["clocks"], 4);
    EXPECT_TRUE(report["parameters"].contains("M"));
    EXPECT_FALSE(report.contains("mismatch"));
  }
}

// Each point is nearest to the circle along the axis that rests.
TEST_F(Output, RandomArcsStayNextToTheCircle) {
  Random random(8);
  for (int i = 0; i < 40; ++i) {
    const auto q = static_cast<std::int64_t>(random.below(4'000'000)) + 1;
    const double r = std::sqrt(static_cast<double>(q));
    const auto along =
        static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(r * 0.7) + 1));
    const auto across = std::llround(std::sqrt(static_cast<double>(q - along * along)));
    const bool late = random.one_in_power(1);
    std::int64_t x = late ? along : across, y = late ? across : along;
    const Said said = run("arc --radius2 " + std::to_string(q) + " --from " + std::to_string(x) +
                          "," + std::to_string(y) + " --csv a.csv --report r.json");
    ASSERT_EQ(said.status, 0) << said.err;
    double worst = std::abs(std::hypot(x, y) - r);
    std::int64_t clock = 0, gaps = 0;
    for (const auto& row : rows(slurp(file("a.csv")))) {
      if (row[0] == "clock") continue;
      const int dx = std::stoi(row[1]), dy = std::stoi(row[2]);
      ASSERT_TRUE((dx == 0 || dx == -1) && (dy == 0 || dy == 1) && dx - dy != 0);
      ASSERT_TRUE(x > y ? dy == 1 : dx == -1);
      x += dx;
      y += dy;
      ASSERT_EQ(std::stoll(row[3]), x);
      ASSERT_EQ(std::stoll(row[4]), y);
      const double line = static_cast<double>(x > y ? y : x);
      const auto nearest = std::llround(std::sqrt(static_cast<double>(q) - line * line));
      ASSERT_EQ(x > y ? x : y, nearest) << "R^2 = " << q << " at " << x << "," << y;
      gaps += std::stoll(row[0]) - clock - 1;
      clock = std::stoll(row[0]);
      worst = std::max(worst, std::abs(std::hypot(x, y) - r));
    }
    EXPECT_EQ(x, 0);
    EXPECT_EQ(y, std::llround(r));
    EXPECT_LE(gaps, 1) << "the sector change costs at most one clock";
    EXPECT_NEAR(json::parse(slurp(file("r.json")))["max_deviation"].get<double>(), worst, 1e-9);
  }
}

TEST_F(Output, CountStopsTheArc) {
  ASSERT_EQ(run("arc --radius 100 --csv all.csv").status, 0);
  const std::string all = slurp(file("all.csv"));
  for (const int count : {1, 70, 71, 72, 140}) {
    ASSERT_EQ(run("arc --radius 100 --csv part.csv --count " + std::to_string(count)).status, 0);
    const std::string part = slurp(file("part.csv"));
    EXPECT_EQ(rows(part).size(), static_cast<std::size_t>(count) + 1);
    EXPECT_EQ(all.rfind(part, 0), 0U);
  }
}

TEST_F(Output, PathStepsAndEndsOnItsTargets) {
  write("p.ngc",
        "G21 G90\nG1 X2 Y1\nG2 X2 Y-1 I0 J-1 (half a turn)\nF5\nG91 G1 X-.5\nG90 G0 X0 Y0\n");
  const Said said = run("path p.ngc --steps-per-mm 10 --csv p.csv --report r.json");
  ASSERT_EQ(said.status, 0) << said.err;
  const std::vector<std::pair<int, int>> targets{{20, 10}, {20, -10}, {15, -10}, {0, 0}};
  int x = 0, y = 0;
  std::size_t segment = 1;
  for (const auto& row : rows(slurp(file("p.csv")))) {
    if (row[0] == "segment") continue;
    const auto now = static_cast<std::size_t>(std::stoul(row[0]));
    if (now != segment) {
      ASSERT_EQ(std::make_pair(x, y), targets[segment - 1]);
      ASSERT_EQ(now, segment + 1);
      segment = now;
    }
    const int dx = std::stoi(row[1]), dy = std::stoi(row[2]);
    ASSERT_TRUE(std::abs(dx) <= 1 && std::abs(dy) <= 1 && (dx != 0 || dy != 0));
    x += dx;
    y += dy;
    ASSERT_EQ(std::stoi(row[3]), x);
    ASSERT_EQ(std::stoi(row[4]), y);
  }
  EXPECT_EQ(segment, 4U);
  EXPECT_EQ(std::make_pair(x, y), targets[3]);
  const json report = json::parse(slurp(file("r.json")));
  EXPECT_EQ(report["verdict"], "match");
  EXPECT_TRUE(report.contains("max_deviation"));
}

TEST_F(Output, SweepsAreSilentWithoutATerminalAndSayTheVerdict) {
  for (const char* sweep : {"linear --exhaustive --m 5 --n 2", "circular --random 50 --width 8",
                            "linear --hostile 5000 --m 6 --n 3 --jobs 1"}) {
    const Said said = run("sweep " + std::string(sweep) + " --seed 3 --report r.json");
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_EQ(said.out.find_first_of("\r\x1b"), std::string::npos) << said.out;
    EXPECT_NE(said.out.find("verdict: match"), std::string::npos) << said.out;
    const json report = json::parse(slurp(file("r.json")));
    EXPECT_GT(report["clocks"], 1000);
    EXPECT_EQ(report["seed"], 3);
  }
}

TEST_F(Output, ListNamesEveryBuiltShape) {
  const std::string out = run("list").out;
  for (const char* shape : {"M=5 N=2", "M=6 N=3", "M=8 N=5", "M=16 N=12", "M=16 N=13", "M=24 N=21",
                            "M=32 N=26", "W=4", "W=8", "W=12", "W=16", "W=24", "W=32"}) {
    EXPECT_NE(out.find(shape), std::string::npos) << shape;
  }
}

}  // namespace
}  // namespace cosim::test
