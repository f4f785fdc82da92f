// Programs from files: the project's own examples, other people's programs.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numbers>

#include "tb/util/read_file.h"
#include "tests/studies/toolpath/model/helpers.h"
#include "tests/support/root.h"

namespace cosim::toolpath {
namespace {

namespace fs = std::filesystem;
using std::numbers::pi;

std::string example(const std::string& name) {
  return (test::project_root() / "tests/toolpaths" / name).string();
}

Program program_of(const std::string& path) { return read_gcode(read_file(path), path); }

// The signed area, in square mm, of the closed contour that segments first to last draw.
double area(const std::vector<Step>& path, std::uint32_t first, std::uint32_t last, double scale) {
  double sum = 0;
  for (const Step& s : path) {
    if (s.segment < first || s.segment > last) continue;
    sum += static_cast<double>((s.at.x - s.dx) * s.dy - (s.at.y - s.dy) * s.dx) / 2;
  }
  return sum / (scale * scale);
}

TEST(Examples, TheFlangeEnclosesItsAreas) {
  const Program program = program_of(example("flange.ngc"));
  EXPECT_EQ(program.motions.size(), 39u);
  EXPECT_EQ(program.other_axis_moves, 22u);
  constexpr double scale = 20;
  const Plan p = plan(program, scale);
  const std::vector<Step> path = walked(p);
  ASSERT_EQ(flaw(p, path), "");
  EXPECT_EQ(path.back().at, (Point{0, 0}));

  struct Contour {
    std::uint32_t first;
    std::uint32_t last;
    double area;       ///< positive anticlockwise
    double perimeter;  ///< at most
  };
  const double keyhole = 2 * pi - 2 * std::asin(0.6);  // the long arc of its R = 5 circle
  const Contour contours[] = {
      {2, 9, -(100 * 80 - (4 - pi) * 12 * 12), 360},
      {11, 11, pi * 20 * 20, 126},
      {13, 13, -pi * 4 * 4, 26},
      {15, 15, -pi * 4 * 4, 26},
      {17, 17, -pi * 4 * 4, 26},
      {19, 19, -pi * 4 * 4, 26},
      {21, 24, 12.5 * (keyhole - std::sin(keyhole)) + 6 * 2 + pi * 3 * 3 / 2, 39},
      {26, 29, 25.4 * 6.35 + pi * 3.175 * 3.175, 71},
      {31, 34, 12 * 6, 34},
      {36, 38, -pi * 10 * 10 / 2, 63},
  };
  for (const Contour& c : contours) {
    const auto& end = p.segments[c.last - 1].end;
    EXPECT_EQ(p.segments[c.first - 1].start, end) << c.first;
    // Half a step of the machine and at most half a step of quantisation along the whole way.
    EXPECT_NEAR(area(path, c.first, c.last, scale), c.area, c.perimeter / scale) << c.first;
  }
}

TEST(Examples, TheHexafoilClosesAtEveryScale) {
  const Program program = program_of(example("hexafoil.ngc"));
  ASSERT_EQ(program.motions.size(), 10u);
  for (const double scale : {0.1, 1.0, 7.3, 40.0}) {
    const Plan p = plan(program, scale);
    const std::vector<Step> path = walked(p);
    EXPECT_EQ(flaw(p, path), "") << scale;
    EXPECT_LE(p.largest_closing, 3) << scale;
    if (scale < 7) continue;
    // Three lenses of two segments of 60 degrees each, clockwise.
    const double lenses = 3 * 40 * 40 * (pi / 3 - std::sin(pi / 3));
    EXPECT_NEAR(area(path, 3, 5, scale), -lenses, 252 / scale) << scale;
    EXPECT_NEAR(area(path, 7, 9, scale), -lenses, 252 / scale) << scale;
  }
}

// Programs that other people's tools wrote, where the folder is given.
TEST(OtherPeoples, ProgramsAreDrawn) {
  const char* folder = std::getenv("COSIM_TOOLPATHS");
  if (folder == nullptr || !fs::is_directory(folder)) {
    GTEST_SKIP() << "not here: COSIM_TOOLPATHS names no folder";
  }
  struct File {
    const char* name;
    std::size_t motions;  ///< blocks that change X or Y, counted by a script of its own
    PointMm end;
  };
  const File files[] = {
      {"cncjs_circle.gcode", 6, {0, 0}},
      {"cncjs_g2_rounded_rect.gcode", 7, {10, 10}},
      {"sc_circles_with_R.nc", 15, {1860.368, 274.475}},
      {"svg2gcode_circular_interpolation.gcode", 79, {7, 2}},
      {"svg2gcode_smooth_curves_arcs.gcode", 1695, {59.288, 10.298}},
      {"svg2gcode_smooth_curves_lines.gcode", 4755, {59.288, 10.298}},
      {"toolpath_one_inch_circle.nc", 6, {0, 0}},
  };
  for (const File& file : files) {
    SCOPED_TRACE(file.name);
    const Program program = program_of((fs::path(folder) / file.name).string());
    EXPECT_EQ(program.motions.size(), file.motions);
    EXPECT_EQ(program.motions.back().end, file.end);
    for (const double scale : {3.0, 40.0, 80.7}) {
      const Plan p = plan(program, scale);
      EXPECT_EQ(flaw(p, walked(p)), "") << scale;
      EXPECT_LE(p.largest_closing, 3) << scale;
    }
  }
  const std::string missing_radius = (fs::path(folder) / "toolpath_arc_r.nc").string();
  EXPECT_EQ(error_of([&] { program_of(missing_radius); }),
            missing_radius + ":3:1: G2 needs a radius: I, J or R");
}

}  // namespace
}  // namespace cosim::toolpath
