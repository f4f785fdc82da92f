// cosim dda: lines, circles and conics, against the curves' own equations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/cli/checkpoint.h"
#include "tests/cli/drawing.h"
#include "tests/cli/help.h"
#include "tests/cli/memory.h"
#include "tests/cli/picture.h"
#include "tests/cli/program.h"
#include "tests/support/sanitized.h"

namespace cosim::cli {
namespace {

using Dda = InAFolder;

struct Row {
  long clock = 0, dx = 0, dy = 0, x = 0, y = 0;
};

std::vector<Row> rows(const Arguments& arguments) {
  std::vector<Row> all;
  const Drawing d = draw(joined({"dda"}, arguments));
  for (const auto& [clock, dx, dy, x, y] : d.steps("clock")) all.push_back({clock, dx, dy, x, y});
  return all;
}

// 2^6 clocks, one less for the shift, and one that shifts; the k-th step of an axis of D steps on
// the clock ceil(64 k / 2 D).
TEST_F(Dda, DrawsALine) {
  const auto all = rows({"--line", "27,-9", "--width", "6"});
  ASSERT_FALSE(all.empty());
  long x = 0, y = 0;
  for (const Row& r : all) {
    if (r.dx != 0) EXPECT_EQ(r.clock, 1 + (64 * ++x + 53) / 54);
    if (r.dy != 0) EXPECT_EQ(r.clock, 1 + (64 * ++y + 17) / 18);
    EXPECT_EQ(r.x, x);
    EXPECT_EQ(r.y, -y);
  }
  EXPECT_EQ(all.back().x, 27);
  EXPECT_EQ(all.back().y, -9);
  EXPECT_EQ(all.back().clock, 33);
}

TEST_F(Dda, DrawsAQuarterCircle) {
  for (const char* update : {"parallel", "sequential"}) {
    const auto all = rows({"--circle", "200", "--preload", "half", "--update", update});
    for (const Row& r : all) EXPECT_NEAR(std::hypot(r.x, r.y), 200, 1.3);
    EXPECT_EQ(all.back().x, 0);
    EXPECT_EQ(all.back().y, 200);
  }
}

// x^2 + xy + 2 y^2 = 10000, once round: F / |grad F| is about the distance.
TEST_F(Dda, DrawsAConic) {
  const auto all =
      rows({"--conic", "1,1,2,0,0,-10000", "--from", "100,0", "--update", "sequential"});
  long left = 0, below = 0;
  for (const Row& r : all) {
    const auto x = static_cast<double>(r.x), y = static_cast<double>(r.y);
    const double off = (x * x + x * y + 2 * y * y - 10000) / std::hypot(2 * x + y, x + 4 * y);
    EXPECT_LT(std::fabs(off), 2) << r.x << ' ' << r.y;
    left = std::min(left, r.x);
    below = std::min(below, r.y);
  }
  EXPECT_NEAR(static_cast<double>(left), -100 * std::sqrt(8.0 / 7), 2);
  EXPECT_NEAR(static_cast<double>(below), -100 * std::sqrt(4.0 / 7), 2);
  EXPECT_NEAR(static_cast<double>(all.back().x), 100, 2);
}

// Its path goes through the ellipse's centre.
TEST_F(Dda, IsOffByAFiniteDistance) {
  const Ended ended = cosim({"dda", "--conic", "1,-1,1,0,0,-1", "--from", "1,0", "--update",
                             "sequential", "--report", folder.path("r")});
  EXPECT_TRUE(has(ended.out, "largest deviation 0.816 steps"));
  EXPECT_TRUE(has(folder.text("r"), "\"max_deviation\": 0.8164965809"));
}

TEST_F(Dda, TakesTheSmallestMachineThatHoldsTheCurve) {
  const auto machine = [](const Arguments& arguments) {
    const Ended ended = cosim(arguments);
    return ended.out.substr(0, ended.out.find(':'));
  };
  EXPECT_EQ(machine({"dda", "--line", "63,1"}), "dda W=6");
  EXPECT_EQ(machine({"dda", "--line", "63,-64"}), "dda W=8");
  EXPECT_EQ(machine({"dda", "--circle", "256"}), "dda W=16");
  // Its codes fit 8 bits, its rates do not.
  EXPECT_EQ(machine({"dda", "--conic", "1,1,2,0,0,-10000", "--from", "100,0"}), "dda W=16");
}

void expect_refused_dda(const Arguments& arguments, const std::string& error) {
  const Ended ended = cosim(joined({"dda"}, arguments));
  EXPECT_EQ(ended.out, "");
  EXPECT_TRUE(refusal(ended).starts_with("cosim: " + error)) << ended.err;
}

TEST_F(Dda, RefusesWhatItCannotDraw) {
  const std::string one = "dda: one of --line, --circle and --conic is needed, ";
  expect_refused_dda({}, one + "none is given\n");
  expect_refused_dda({"--line", "1,2", "--circle", "4"}, one + "more are given\n");
  expect_refused_dda({"--line", "1,2,3"}, "--line: '1,2,3' is not X,Y\n");
  expect_refused_dda({"--line", "1,x"}, "--line: Y: 'x' is not a whole number from ");
  expect_refused_dda({"--line", "64,1", "--width", "6"},
                     "a curve that needs 7 bits does not fit dda W=6\n");
  expect_refused_dda({"--line", "1,2", "--update", "late"},
                     "--update: 'late' is not parallel or sequential\n");
  expect_refused_dda({"--line", "1,2", "--preload", "full"},
                     "--preload: 'full' is not zero or half\n");
  expect_refused_dda({"--line", "1,2", "--from", "1,1"}, "--from: belongs to --conic\n");
  expect_refused_dda({"--conic", "1,0,1,0,0,-9"}, "--from: is needed\n");
  expect_refused_dda({"--conic", "1,0,1,0,0,-9", "--from", "5,0"},
                     "conic: it does not pass (5, 0)\n");
  expect_refused_dda({"--conic", "1,0,-1,0,0,0", "--from", "5,5"}, "conic: it is degenerate");
  expect_refused_dda(
      {"--conic", "1,0,1,0,0,-2500", "--from", "50,0", "--width", "6"},
      "conic: its rates overflow dda W=6 at (50, 0) on clock 0: they are (0, 100)\n");
  expect_refused_dda({"--conic", "1,0,0,0,-4,0", "--from", "0,0"}, "conic: it is no ellipse");
}

TEST_F(Dda, HasAHelpThatNamesEveryOption) {
  expect_in(help({"dda"}),
            {"--line X,Y", "--circle R", "--conic A,B,C,D,E,F", "--from X,Y", "--clocks N",
             "--update HOW", "--preload S", "--as-it-is", "--width W"});
}

// x^2 + 4 y^2 = 1600: each corner of the curve is on it, and it goes all the way around.
TEST_F(Dda, HasAPictureOfAConic) {
  if (!can_plot()) GTEST_SKIP() << "no gnuplot";
  const Picture picture({"dda", "--conic", "1,0,4,0,0,-1600", "--from", "40,0"});
  const std::vector<Dot> curve = picture.curve();
  ASSERT_GT(curve.size(), 80U);
  const auto by = [](auto member) {
    return [member](const Dot& a, const Dot& b) { return a.*member < b.*member; };
  };
  const auto [left, right] = std::minmax_element(curve.begin(), curve.end(), by(&Dot::x));
  const auto [high, low] = std::minmax_element(curve.begin(), curve.end(), by(&Dot::y));
  const double half = (right->x - left->x) / 2;
  EXPECT_NEAR((low->y - high->y) / 2, half / 2, half / 100);
  for (const Dot& d : curve) {
    const double x = (d.x - left->x) / half - 1, y = (d.y - high->y) / half - 0.5;
    EXPECT_NEAR(x * x + 4 * y * y, 1, 0.03);
  }
  EXPECT_GE(picture.path(0).size(), curve.size() / 2);
}

// Where the length is only known on the way, the run ends there.
TEST_F(Dda, ThatGrowsTooLongLosesNothing) {
  folder.write("csv", "kept\n");
  const Ended ended =
      ends(2, cosim({"dda", "--circle", "3000000000", "--plot", folder.path("p.svg"), "--csv",
                     folder.path("csv"), "--clocks", "5000000"}));
  EXPECT_EQ(ended.err, "cosim: --plot: a path of more than 999999 steps is too long to draw\n");
  EXPECT_EQ(folder.text("csv"), "kept\n");
  for (const auto& entry : std::filesystem::directory_iterator(folder.path(""))) {
    EXPECT_NE(entry.path().extension(), ".cosim-new") << entry.path();
  }
}

// What would be too long to draw is refused before it runs.
TEST_F(Dda, ThatWouldBeTooLongIsRefusedFirst) {
  const auto refused = [&](Arguments command, const std::string& error) {
    command.insert(command.end(), {"--csv", folder.write("csv", "kept\n")});
    const Ended ended = cosim(command);
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(refusal(ended), "cosim: " + error + "\n");
    EXPECT_EQ(folder.text("csv"), "kept\n");
    EXPECT_LT(ended.peak, 100'000'000 + test::kept_back);
    EXPECT_FALSE(folder.holds("w.fst") || folder.holds("p.svg"));
  };
  refused({"dda", "--line", "5,3", "--width", "32", "--as-it-is", "--wave", folder.path("w.fst")},
          "--wave: 4294967296 clocks are more than can be drawn, 2000000");
  refused({"dda", "--line", "1000000,1", "--plot", folder.path("p.svg")},
          "--plot: a path of more than 999999 steps is too long to draw");
}

// One of the first hundred cases of this seed reaches the middle of its conic, where the gradient
// vanishes.
TEST_F(Dda, SweptAndKilledGoesOn) {
  const Arguments kept{"sweep", "dda",     "--random", "300000",       "--seed",
                       "6",     "--width", "6",        "--checkpoint", folder.path("state")};
  ASSERT_TRUE(killed_beyond(0, folder, kept)) << "it ended and kept nothing";
  const std::uint64_t done = cases_kept(folder);
  EXPECT_TRUE(killed_beyond(done, folder, kept)) << "it did not go on";
}

TEST_F(Dda, WithEveryKindOfJobDoesNotRunInLanes) {
  const std::string said = refusal(cosim({"sweep", "dda", "--random", "5", "--lanes", "64"}));
  EXPECT_TRUE(
      said.starts_with("cosim: dda W=6, random lines, arcs and conics: its jobs are driven "
                       "one case at a time, not in lanes"));
}

TEST_F(Dda, TakesNoMoreMemoryForMoreCases) { expect_no_more_memory({"dda", "--width", "6"}); }

}  // namespace
}  // namespace cosim::cli
