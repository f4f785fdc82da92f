// Paths of G-code programs: unit steps, numbered by motion, each motion ending on its target.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>
#include <set>

#include "tests/cli/drawing.h"
#include "tests/cli/help.h"
#include "tests/cli/targets.h"
#include "tests/support/members.h"
#include "tests/support/root.h"

namespace cosim::cli {
namespace {

using std::numbers::pi;
using Path = InAFolder;

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::set<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) found.insert(entry.path());
  }
  return {found.begin(), found.end()};
}

Drawing draw_path(const std::string& file, const std::string& scale, const Arguments& more = {}) {
  return draw(joined({"path", file, "--steps-per-mm", scale}, more));
}

// Half a step from its target, or exactly where that is a grid point.
void expect_at(const Target& target, double scale, std::int64_t x, std::int64_t y) {
  constexpr double slack = 1e-6;
  EXPECT_LE(std::abs(target.x * scale - static_cast<double>(x)), 0.5 + slack);
  EXPECT_LE(std::abs(target.y * scale - static_cast<double>(y)), 0.5 + slack);
}

// All that holds of any path.
void expect_path(const Drawing& d, const std::string& program, double scale) {
  const std::vector<Target> targets = targets_of(program);
  std::int64_t x = 0, y = 0;
  std::size_t segment = 1;  // the one whose steps are being made
  for (const auto& [number, dx, dy, at_x, at_y] : d.steps("segment")) {
    const auto next = static_cast<std::size_t>(number);
    ASSERT_GE(next, segment);
    ASSERT_LE(next, targets.size());
    for (; segment < next; ++segment) {
      SCOPED_TRACE("end of segment " + std::to_string(segment));
      expect_at(targets[segment - 1], scale, x, y);
    }
    ASSERT_TRUE(std::abs(dx) <= 1 && std::abs(dy) <= 1 && (dx != 0 || dy != 0)) << dx << " " << dy;
    x += dx;
    y += dy;
    ASSERT_EQ(at_x, x);
    ASSERT_EQ(at_y, y);
  }
  for (; segment <= targets.size(); ++segment) expect_at(targets[segment - 1], scale, x, y);

  EXPECT_EQ(d.report["segments"], targets.size());
  EXPECT_EQ(d.report["steps"], d.csv.size() - 1);
  EXPECT_EQ(d.report["end"], (nlohmann::json{x, y}));
  EXPECT_TRUE(has(d.ended.out, "ends at (" + std::to_string(x) + ", " + std::to_string(y) + ")"));
}

// The signed area that segment `number` encloses, anticlockwise above 0, in square mm.
double area_of(const Drawing& d, std::int64_t number, double scale) {
  double sum = 0;
  for (const auto& [segment, dx, dy, x, y] : d.steps("segment")) {
    if (segment == number) sum += static_cast<double>((x - dx) * dy - (y - dy) * dx) / 2;
  }
  return sum / (scale * scale);
}

TEST_F(Path, OfTheExamplesEndsEachMotionOnItsTarget) {
  for (const fs::path& file : files_in(test::project_root() / "tests/toolpaths")) {
    if (file.extension() != ".ngc") continue;
    for (const std::string scale : {"3", "40", "25.3"}) {
      SCOPED_TRACE(file.string() + " at " + scale);
      expect_path(draw_path(file.string(), scale), text_of(file), std::stod(scale));
    }
  }
}

TEST_F(Path, OfOtherPeoplesProgramsEndsEachMotionOnItsTarget) {
  const char* theirs = std::getenv("COSIM_TOOLPATHS");
  if (theirs == nullptr || !fs::is_directory(theirs)) {
    GTEST_SKIP() << "not here: COSIM_TOOLPATHS names no folder";
  }
  int drawn = 0;
  for (const fs::path& file : files_in(theirs)) {
    SCOPED_TRACE(file.string());
    const Arguments command{"path", file.string(), "--steps-per-mm", "20"};
    const Ended ended = cosim(command);
    if (ended.status == 2) {  // some of them are wrong on purpose
      EXPECT_EQ(ended.err.rfind("cosim: " + file.string() + ":", 0), 0U) << ended.err;
      continue;
    }
    expect_path(draw_path(file.string(), "20"), text_of(file), 20);
    ++drawn;
  }
  EXPECT_GT(drawn, 0);
}

TEST_F(Path, TurnsAsTheProgramSays) {
  const std::string flange = (test::project_root() / "tests/toolpaths/flange.ngc").string();
  const Drawing d = draw_path(flange, "50");
  // Half a step of the machine and one of the grid along the whole way round.
  EXPECT_NEAR(area_of(d, 11, 50), pi * 20 * 20, 126.0 * 1.5 / 50);  // the bore, G3
  EXPECT_NEAR(area_of(d, 13, 50), -pi * 4 * 4, 26.0 * 1.5 / 50);    // a hole, G2
}

// Blocks that do not move X or Y are no segments, those of less than a step are.
constexpr const char* kProgram =
    "G21 G90\n"
    "G0 Z5\n"
    "G1 X1 F100\n"
    "Z-1\n"
    "X1 Y0 (to where it stands)\n"
    "X1.01\n"
    "Y-2\n"
    "G91 X-1.01 Y2\n";

TEST_F(Path, CountsTheBlocksThatMoveXOrY) {
  const Drawing d = draw_path(folder.write("p.ngc", kProgram), "10");
  std::vector<std::string> expected{"segment,dx,dy,x,y"};
  const auto add = [&](int segment, int dx, int dy, int x, int y) {
    expected.push_back(std::to_string(segment) + "," + std::to_string(dx) + "," +
                       std::to_string(dy) + "," + std::to_string(x) + "," + std::to_string(y));
  };
  for (int i = 1; i <= 10; ++i) add(1, 1, 0, i, 0);
  for (int i = 1; i <= 20; ++i) add(3, 0, -1, 10, -i);
  ASSERT_EQ(d.csv.size(), expected.size() + 20);
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), d.csv.begin()));
  for (std::size_t i = expected.size(); i < d.csv.size(); ++i) {
    EXPECT_EQ(d.csv[i].rfind("4,", 0), 0U) << d.csv[i];
  }
  EXPECT_EQ(d.csv.back().substr(d.csv.back().size() - 4), ",0,0");
  test::expect_members(d.report,
                       R"({"segments": 4, "other_axis_moves": 2, "lines": 3, "arcs": 0})");
  EXPECT_TRUE(has(d.ended.out, "4 motions at 10 steps/mm, 2 moves of other axes not drawn\n"));
}

TEST_F(Path, TellsWhatItDidNotRead) {
  const auto said = [&](const std::string& text) {
    const std::string file = folder.write("p.ngc", text);
    const Drawing d = draw_path(file, "10");
    const std::vector<std::string> out = lines(d.ended.out);
    EXPECT_EQ(d.report["segments"], 1);
    return std::make_pair(
        out.size() > 1 && out[1].starts_with(file) ? out[1].substr(file.size()) : "",
        d.report["lines_unread"].get<int>());
  };
  using Said = std::pair<std::string, int>;
  EXPECT_EQ(said("G0 X1\nM30\nG0 X2\n\n(b)\nM30\n%\n"),
            Said(": the program ends in line 2; 2 lines behind it not read", 2));
  EXPECT_EQ(said("%\nG0 X1\n%\nG0 X2"),
            Said(": the program ends in line 3; 1 line behind it not read", 1));
  EXPECT_EQ(said("%\nG0 X1\nM2\n%\n"), Said("", 0));
}

TEST_F(Path, NamesTheMachinesItRunsOn) {
  const std::string quarter =
      folder.write("quarter.ngc", "G0 X10\nG3 X0 Y10 I-10\n");  // R = 100 steps, a line of 100
  Drawing d = draw_path(quarter, "10");
  expect_has(d.ended.out, {"\nlinear M=8 N=5: 1 line, 100 steps, ", "\ncircular W=8: 1 arc, "});
  d = draw_path(quarter, "10", {"--m", "16", "--n", "13", "--width", "24"});
  expect_has(d.ended.out, {"\nlinear M=16 N=13: ", "\ncircular W=24: "});
  // Only lines: no circular machine.
  d = draw_path(folder.write("line.ngc", "G0 X1\n"), "1");
  EXPECT_FALSE(has(d.ended.out, "circular"));
  EXPECT_EQ(d.report["design"], "linear");
}

TEST_F(Path, DeviatesLeastWithTheBestCodes) {
  const std::string flange = (test::project_root() / "tests/toolpaths/hexafoil.ngc").string();
  const auto deviation = [&](const char* rule) {
    return draw_path(flange, "40", {"--code", rule}).report["machine_error"].get<double>();
  };
  EXPECT_LE(deviation("best"), deviation("greedy"));
  EXPECT_EQ(deviation("best"), draw_path(flange, "40").report["machine_error"].get<double>());
}

TEST_F(Path, HasAHelpThatNamesEveryOption) {
  expect_in(help({"path"}), {"FILE", "--steps-per-mm S", "--csv FILE", "segment,dx,dy,x,y",
                             "--report FILE", "--seed S"});
}

}  // namespace
}  // namespace cosim::cli
